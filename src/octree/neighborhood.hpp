/// \file
/// What a leaf's tetrahedra depend on: the key of its neighbourhood, and the vertex at each slot.
///
/// Requires a forest that is balanced across faces and edges (octree/balance.hpp).
#pragma once

#include "octree/slots.hpp"

namespace unsliver::octree {

/// A leaf seen from the block of its parent's children.
struct LeafView {
  const Forest& forest;
  const Block& block;
  int place;
  Cell cell;

  std::size_t neighbor(int offset) const {
    return static_cast<std::size_t>(place) + static_cast<std::size_t>(offset);
  }
};

/// What is beyond a face of a leaf.
enum FaceState : std::uint64_t {
  kNothing = 0,   ///< no vertex that matters: a larger leaf, or an equal one without centre
  kCentered = 1,  ///< an equal leaf with a centre
  kHalved = 2,    ///< four leaves of half the side; the face's middle is a vertex, their centres may be
  kBrickEnd = 3,  ///< the end of the forest
};

/// A neighbourhood in 49 bits: which edges have a hanging middle (bits 0..11, in the order of kEdgeSlots),
/// has the leaf a centre (12), and for each face its state and, if halved, which of the four leaves have a
/// centre (from bit 13 on, 2 + 4 bits each).
class Key {
 public:
  explicit constexpr Key(std::uint64_t bits) : bits_(bits) {}

  constexpr std::uint64_t bits() const { return bits_; }
  constexpr bool has_hanging_edge(int edge) const { return bits_ >> edge & 1; }
  constexpr bool has_center() const { return bits_ >> 12 & 1; }
  constexpr FaceState face(int face) const { return FaceState(bits_ >> (13 + 6 * face) & 3); }
  constexpr bool half_has_center(int face, int j) const { return bits_ >> (15 + 6 * face + j) & 1; }

  static constexpr std::uint64_t edge_bit(int edge) { return std::uint64_t{1} << edge; }
  static constexpr std::uint64_t center_bit() { return std::uint64_t{1} << 12; }
  static constexpr std::uint64_t face_bits(int face, std::uint64_t state, std::uint64_t centers) {
    return (state | centers << 2) << (13 + 6 * face);
  }

 private:
  std::uint64_t bits_;
};

/// Is the slot beyond a face whose other side is halved?
constexpr bool is_halved_slot(Key key, int slot) {
  return slot >= kFirstBeyond && key.face(face_of_beyond(slot)) == kHalved;
}

/// Key bits of a halved face: the four leaves' centres.
inline std::uint64_t halved_face(const LeafView& leaf, int face) {
  const NodeId first = leaf.block.link[leaf.neighbor(kFaceOffset[std::size_t(face)])];
  std::uint64_t centers = 0;
  for (int j = 0; j < 4; ++j)
    centers |= std::uint64_t(leaf.forest[first + child_at_face(face, j)].flags & kHasCenter) << j;
  return Key::face_bits(face, kHalved, centers);
}

inline Key key_of(const LeafView& leaf) {
  static_assert(kHasCenter == 1);
  const std::uint64_t split = Block::around(leaf.block.split, leaf.place);
  const std::uint64_t centered = Block::around(leaf.block.centered, leaf.place);
  const std::uint64_t exists = Block::around(leaf.block.exists, leaf.place);
  const bool hanging = (split & kFaceAndEdgeNeighbors) != 0;
  std::uint64_t key = (centered & neighbor_bit(0)) != 0 ? Key::center_bit() : 0;
  if (hanging)
    for (int e = 0; e < 12; ++e)
      if ((split & kEdgeNeighbors[std::size_t(e)]) != 0) key |= Key::edge_bit(e);
  for (int f = 0; f < 6; ++f) {
    const std::uint64_t beyond = neighbor_bit(kFaceOffset[std::size_t(f)]);
    if (hanging && (split & beyond) != 0)
      key |= halved_face(leaf, f);
    else if ((centered & beyond) != 0)
      key |= Key::face_bits(f, kCentered, 0);
    else if ((exists & beyond) == 0)
      key |= Key::face_bits(f, kBrickEnd, 0);
  }
  return Key(key);
}

/// A vertex, as one of the points that its owner can own: 0 the centre, 1 + c corner c. A point that is a
/// corner of several leaves is owned by the one in its highest octant.
struct VertexRef {
  NodeId leaf;
  int own;

  unsigned bit() const { return 1u << own; }
};

namespace detail {

inline bool is_aligned(const Cell& cell, int slot, int exponent) {
  const auto g = grid_coordinates(slot);
  const int half = cell.exponent - 1;  // corner slots only: the coordinates are even
  const std::int64_t x = cell.x + (std::int64_t(g[0]) << half), y = cell.y + (std::int64_t(g[1]) << half),
                     z = cell.z + (std::int64_t(g[2]) << half);
  return ((x | y | z) & ((std::int64_t{1} << exponent) - 1)) == 0;
}

/// The leaf in the octant of a point, if the point is its corner; kNoNode else.
inline NodeId leaf_with_corner(const LeafView& leaf, int slot, int octant) {
  const OctantCell at = kOctants[std::size_t(slot)][std::size_t(octant)];
  const std::size_t i = leaf.neighbor(at.offset);
  const NodeId n = leaf.block.node[i];
  if (n == kNoNode) return kNoNode;
  if (leaf.block.split >> i & 1) {
    NodeId child = leaf.block.link[i] + at.child;
    while (!leaf.forest[child].is_leaf()) child = leaf.forest[child].link + (7 - octant);
    return child;
  }
  if (!is_corner_slot(slot)) return kNoNode;
  const bool is_corner =
      (leaf.block.same >> i & 1) != 0 || is_aligned(leaf.cell, slot, leaf.forest[n].exponent);
  return is_corner ? n : kNoNode;
}

inline VertexRef grid_vertex(const LeafView& leaf, int slot) {
  int octant = 7;
  NodeId owner = leaf_with_corner(leaf, slot, octant);
  while (owner == kNoNode) owner = leaf_with_corner(leaf, slot, --octant);
  return {owner, 1 + (7 - octant)};
}

inline VertexRef vertex_beyond(const LeafView& leaf, int slot) {
  const int face = face_of_beyond(slot), j = (slot - kFirstBeyond) & 3;
  const std::size_t i = leaf.neighbor(kFaceOffset[std::size_t(face)]);
  const bool halved = leaf.block.split >> i & 1;
  return {halved ? leaf.block.link[i] + child_at_face(face, j) : leaf.block.node[i], 0};
}

}  // namespace detail

/// The vertex at a slot. Requires that there is one.
inline VertexRef vertex_at(const LeafView& leaf, int slot) {
  if (slot == kCenterSlot) return {leaf.cell.node, 0};
  return slot < kFirstBeyond ? detail::grid_vertex(leaf, slot) : detail::vertex_beyond(leaf, slot);
}

}  // namespace unsliver::octree
