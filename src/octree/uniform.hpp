/// \file
/// The bulk of most meshes: nodes whose children, like all around them, are equal leaves with centres.
///
/// Such a node's tetrahedra need no keys and no search for owners: each child owns its centre (its first own
/// vertex) and its lower corner (the second), and so do the leaves around.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "octree/template.hpp"

namespace unsliver::octree {

/// Does the node at a place, and each of its 26 neighbours, have the flag kUniform?
bool is_uniform(const Block& block, int place);

/// Own vertices 0 and 1: the centre and the lower corner.
inline constexpr std::uint16_t kUniformUse = 3;

/// The tetrahedra of the eight children in one go.
class UniformPattern {
 public:
  UniformPattern();

  std::size_t tet_count() const { return tets_.size(); }
  /// Calls visit(leaf, own vertices that they use) for the children and the leaves around.
  template <class Visit>
  void visit_uses(const Block& block, int place, const Visit& visit) const {
    for_each_child_place(block, place, [&](std::size_t at, NodeId leaf) {
      if (uses_[at] != 0) visit(leaf, uses_[at]);
    });
  }
  /// Writes them for the node at a place of `block`, for which is_uniform; returns the end. In the order, and
  /// with the corners in the order, of the children's templates.
  std::array<std::uint32_t, 4>* write(const Forest& forest, const Block& block, int place,
                                      std::array<std::uint32_t, 4>* out) const;

 private:
  /// Corners as 2 * (place in the block of children) + (0 the centre, 1 the lower corner of the leaf there).
  std::vector<std::array<std::uint8_t, 4>> tets_;
  std::array<std::uint8_t, 64> uses_{};  ///< by place: own vertices, of kUniformUse
};

}  // namespace unsliver::octree
