/// \file
/// Vertices of others among those of the forest: input vertices, see refine/figure_8_octree.hpp.
#pragma once

#include <functional>
#include <span>

#include "lattice/level.hpp"
#include "octree/forest.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::octree {

/// What a guest has to say during a run, in this order.
class Guest {
 public:
  virtual ~Guest() = default;

  /// Names the phases that begin.
  using EnterPhase = std::function<void(const char*)>;
  /// The forest is balanced and will not change. The guest sets kDisturbed, in leaves and their parents,
  /// and kVisited.
  virtual void on_forest(Forest& forest, const EnterPhase& enter) = 0;
  /// The points (world) that may take the place of tetrahedra that a leaf with kDisturbed owns. Asked from
  /// all threads.
  virtual std::span<const Vec3> neighbours(NodeId leaf) const = 0;
  /// How many tetrahedra the guest will add, how many vertices at most, and what he holds.
  virtual std::uint64_t tet_count() const = 0;
  virtual std::uint64_t most_vertices() const = 0;
  virtual std::uint64_t bytes() const = 0;
  /// How many numbers of vertices the guest wants before the forest's.
  virtual VertexId vertex_count() const = 0;
  /// Vertex `number` is the point p (world), owned by a leaf with kVisited or kOutside; returns its level,
  /// which is `coarse` where the guest does not mind. Called from all threads.
  virtual std::uint8_t on_vertex(VertexId number, const Vec3& p, lattice::Level coarse) = 0;
  /// The mesh is there, but for the guest's first vertices, which have their places only, and all tetrahedra
  /// with a vertex of the guest's.
  virtual void complete(TetMesh& mesh) = 0;
};

/// Does a tetrahedron of the forest (world) give way to one of the points: is that its corner, or in conflict
/// with it?
bool gives_way(const Tet& t, std::span<const Vec3> points);

}  // namespace unsliver::octree
