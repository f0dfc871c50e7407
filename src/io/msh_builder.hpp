/// \file
/// Collects the nodes and elements of a Gmsh file into a mesh.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "io/scanner.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// Gmsh's labels of an element: the group that the user named, and the piece of geometry; 0 = none.
struct MshLabels {
  std::int64_t physical = 0;
  std::int64_t elementary = 0;
};

/// Nodes carry arbitrary tags; elements name nodes by tag.
class MshBuilder {
 public:
  void add_node(std::int64_t tag, const Vec3& point);
  /// To be called between the nodes and the elements. Error kBadInput when a tag stands twice.
  void finish_nodes(const Scanner& place);
  /// Error kBadInput when there is no such node.
  VertexId vertex(std::int64_t tag, const Scanner& place) const;
  void add_tet(const std::array<VertexId, 4>& tet, const MshLabels& labels, const Scanner& place);
  void add_triangle(const std::array<VertexId, 3>& triangle, const MshLabels& labels, const Scanner& place);
  TetMesh take_mesh();

 private:
  // An element's label is its physical group, or else its geometry. Where no element is in a group and all
  // lie on one geometry, there is nothing to tell apart, and no labels are kept.
  class Labels {
   public:
    void add(const MshLabels& labels, const Scanner& place);
    std::vector<std::int32_t> take();

   private:
    std::vector<std::int32_t> values_;
    bool has_physical_ = false;
  };

  TetMesh mesh_;
  Labels regions_, triangle_labels_;
  std::vector<std::int64_t> tags_;
  std::vector<std::pair<std::int64_t, VertexId>> by_tag_;  // sorted; empty when the tags are 1, 2, ... n
};

}  // namespace unsliver::io
