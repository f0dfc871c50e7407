/// \file
/// Vertices of others among those of the forest: input vertices, see refine/figure_8_octree.hpp.
#pragma once

#include "octree/forest.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::octree {

/// What a guest has to say during a run, in this order.
class Guest {
 public:
  virtual ~Guest() = default;

  /// The forest is balanced and will not change. The guest may take kInside and kDeep from leaves and
  /// kUniform from their parents: then keeps() is asked for their tetrahedra.
  virtual void on_forest(Forest& forest) = 0;
  /// Is a tetrahedron of the forest's points (world) still one beside the guest's? Asked from all threads.
  virtual bool keeps(const Tet& t) const = 0;
  /// How many tetrahedra the guest will add, and what he holds.
  virtual std::uint64_t tet_count() const = 0;
  virtual std::uint64_t bytes() const = 0;
  /// How many numbers of vertices the guest wants before the forest's.
  virtual VertexId vertex_count() const = 0;
  /// Vertex `number` is the point p (world) that the leaf owns; returns its level. Called from all threads.
  virtual std::uint8_t on_vertex(VertexId number, const Vec3& p, const Cell& owner, const Node& leaf) = 0;
  /// The mesh is there, but for the guest's first vertices, which have their places only, and all tetrahedra
  /// with a vertex of the guest's.
  virtual void complete(TetMesh& mesh) = 0;
};

}  // namespace unsliver::octree
