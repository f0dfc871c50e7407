/// \file
/// A node's eight children and the layer of cells around them: 4 x 4 x 4 cells of equal side.
///
/// Place (i, j, k), each in 0..3, has number i + 4j + 16k; the children are those with i, j, k in {1, 2}. The
/// neighbour of place p by (dx, dy, dz), each in -1..1, is p + offset(dx, dy, dz). Where the forest is
/// coarser than the block's cells, the leaf that holds the cell stands in its place.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "octree/forest.hpp"

namespace unsliver::octree {

constexpr int offset(int dx, int dy, int dz) { return dx + 4 * dy + 16 * dz; }
/// The place of the first child; masks of neighbours are stated relative to it.
inline constexpr int kFirstPlace = offset(1, 1, 1);
constexpr int place_of_child(int number) {
  return kFirstPlace + offset(number & 1, number >> 1 & 1, number >> 2);
}

/// What one neighbour of a node fills of the block of the node's children: places, and the neighbour's
/// children there. `offset` is the neighbour's, in the block that holds the node.
struct Share {
  std::int8_t offset;
  std::uint8_t count;
  std::array<std::uint8_t, 8> place, child;
};

/// For the node itself and its 26 neighbours.
extern const std::array<Share, 27> kShares;

struct Block {
  std::array<NodeId, 64> node;        ///< kNoNode beyond the forest
  std::array<std::int32_t, 64> link;  ///< Node::link, -1 beyond the forest
  /// One bit a place: there is a node; it has the block's own exponent; it has children; it is a leaf of the
  /// block's exponent with a centre; it has the flag kUniform.
  std::uint64_t exists = 0, same = 0, split = 0, centered = 0, uniform = 0;

  /// A mask seen from a place that holds a child: bit kFirstPlace + offset is that of the neighbour.
  static std::uint64_t around(std::uint64_t mask, int place) { return mask >> (place - kFirstPlace); }

  void set_none(int place) {
    node[std::size_t(place)] = kNoNode;
    link[std::size_t(place)] = -1;
  }
  void set_larger_leaf(int place, NodeId leaf, std::int32_t its_link) {
    node[std::size_t(place)] = leaf;
    link[std::size_t(place)] = its_link;
    exists |= std::uint64_t{1} << place;
  }
  void set_same(int place, NodeId n, const Node& at) {
    node[std::size_t(place)] = n;
    link[std::size_t(place)] = at.link;
    const std::uint64_t has_children = at.is_leaf() ? 0 : 1, has_center = at.flags & kHasCenter;
    exists |= std::uint64_t{1} << place;
    same |= std::uint64_t{1} << place;
    split |= has_children << place;
    centered |= (has_center & ~has_children) << place;
    uniform |= std::uint64_t(at.flags / kUniform & 1) << place;
  }
};

/// The block whose first child is root (i, j, k): the roots around it.
Block root_block(const Forest& forest, int i, int j, int k);
/// The block of the children of the node at a place of `parent` that holds a child and is split.
Block child_block(const Forest& forest, const Block& parent, int place);

/// Calls visit(place in the block of children, node there) without making that block. Requires that the node
/// at the place and all its neighbours are split.
template <class Visit>
void for_each_child_place(const Block& block, int place, const Visit& visit) {
  for (const Share& share : kShares) {
    const int neighbor = place + share.offset;
    const NodeId first = block.link[std::size_t(neighbor)];
    for (std::size_t i = 0; i < share.count; ++i) visit(share.place[i], first + share.child[i]);
  }
}

}  // namespace unsliver::octree
