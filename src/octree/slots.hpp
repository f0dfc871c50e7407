/// \file
/// The 51 places where a vertex of a leaf's tetrahedra can be, and what is around each: tables of a cube.
///
/// Slots 0..26 are the points of the 3 x 3 x 3 grid on the leaf, x + 3y + 9z with x, y, z in 0..2: corners
/// (no coordinate is 1), middles of edges (one is), of faces (two), the centre (13). They are vertices of the
/// leaf or hanging ones. Slots 27 + 4f + j lie beyond face f = 2 axis + side: the centre of an equal
/// neighbour (j = 0) or those of the four children that touch the face, j running over the two other axes. An
/// octant has bit a set for the upper side of a point along axis a: corner c of a cube is the point whose
/// octant 7 - c holds the cube.
#pragma once

#include <array>
#include <cstdint>

#include "octree/block.hpp"

namespace unsliver::octree {

inline constexpr int kSlotCount = 51;
inline constexpr int kCenterSlot = 13;
inline constexpr int kFirstBeyond = 27;

constexpr int grid_slot(int x, int y, int z) { return x + 3 * y + 9 * z; }
constexpr std::array<int, 3> grid_coordinates(int slot) { return {slot % 3, slot / 3 % 3, slot / 9}; }
constexpr int middle_count(int slot) {
  const auto g = grid_coordinates(slot);
  return (g[0] == 1) + (g[1] == 1) + (g[2] == 1);
}
constexpr bool is_corner_slot(int slot) { return slot < kFirstBeyond && middle_count(slot) == 0; }
constexpr int corner_slot(int corner) {
  return grid_slot(2 * (corner & 1), 2 * (corner >> 1 & 1), 2 * (corner >> 2));
}

/// The neighbour that an octant of a grid point belongs to, and that neighbour's child there.
struct OctantCell {
  std::int8_t offset;
  std::uint8_t child;
};

constexpr OctantCell octant_cell(int slot, int octant) {
  const auto g = grid_coordinates(slot);
  int step[3] = {}, child = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int upper = octant >> axis & 1, at = g[std::size_t(axis)];
    if (at == 0 && !upper) step[axis] = -1;
    if (at == 2 && upper) step[axis] = 1;
    child |= (at == 1 ? upper : 1 - upper) << axis;
  }
  return {std::int8_t(offset(step[0], step[1], step[2])), std::uint8_t(child)};
}

/// octant_cell for slots 0..26.
inline constexpr auto kOctants = [] {
  std::array<std::array<OctantCell, 8>, kFirstBeyond> table{};
  for (int slot = 0; slot < kFirstBeyond; ++slot)
    for (int octant = 0; octant < 8; ++octant)
      table[std::size_t(slot)][std::size_t(octant)] = octant_cell(slot, octant);
  return table;
}();

/// Masks of neighbours relative to kFirstPlace (see Block::around).
constexpr std::uint64_t neighbor_bit(int offset) { return std::uint64_t{1} << (kFirstPlace + offset); }
/// The neighbours that share a grid point of the leaf.
constexpr std::uint64_t neighbors_at(int slot) {
  std::uint64_t mask = 0;
  for (int octant = 0; octant < 8; ++octant) mask |= neighbor_bit(octant_cell(slot, octant).offset);
  return mask & ~neighbor_bit(0);
}

/// The slots of the middles of the twelve edges.
inline constexpr auto kEdgeSlots = [] {
  std::array<std::uint8_t, 12> slots{};
  std::size_t count = 0;
  for (int slot = 0; slot < kFirstBeyond; ++slot)
    if (middle_count(slot) == 1) slots[count++] = std::uint8_t(slot);
  return slots;
}();

/// The neighbours at each of the twelve edges.
inline constexpr auto kEdgeNeighbors = [] {
  std::array<std::uint64_t, 12> masks{};
  for (std::size_t e = 0; e < 12; ++e) masks[e] = neighbors_at(kEdgeSlots[e]);
  return masks;
}();

inline constexpr std::array<int, 6> kFaceOffset = {-1, 1, -4, 4, -16, 16};
constexpr int face_slot(int face) {
  return kCenterSlot + ((face & 1) ? 1 : -1) * (face < 2 ? 1 : face < 4 ? 3 : 9);
}

/// All neighbours across faces and edges.
inline constexpr std::uint64_t kFaceAndEdgeNeighbors = [] {
  std::uint64_t mask = 0;
  for (const std::uint64_t edge : kEdgeNeighbors) mask |= edge;
  return mask;
}();

/// The two axes along a face.
constexpr std::array<int, 2> face_axes(int face) {
  return face < 2 ? std::array{1, 2} : face < 4 ? std::array{0, 2} : std::array{0, 1};
}

/// Child j of the neighbour across a face that touches it.
constexpr int child_at_face(int face, int j) {
  const auto axes = face_axes(face);
  return (1 - (face & 1)) << (face >> 1) | (j & 1) << axes[0] | (j >> 1) << axes[1];
}

/// Slots beyond faces, and the face of one.
constexpr int beyond_slot(int face, int j) { return kFirstBeyond + 4 * face + j; }
constexpr int face_of_beyond(int slot) { return (slot - kFirstBeyond) >> 2; }

/// Position of a slot in quarters of the leaf's side, from its lower corner. `halved`: the neighbour beyond
/// is split.
constexpr std::array<int, 3> slot_position(int slot, bool halved) {
  if (slot < kFirstBeyond) {
    const auto g = grid_coordinates(slot);
    return {2 * g[0], 2 * g[1], 2 * g[2]};
  }
  const int face = face_of_beyond(slot), j = (slot - kFirstBeyond) & 3;
  const auto axes = face_axes(face);
  std::array<int, 3> at{};
  const int depth = halved ? 1 : 2;
  at[std::size_t(face >> 1)] = (face & 1) ? 4 + depth : -depth;
  at[std::size_t(axes[0])] = halved ? 1 + 2 * (j & 1) : 2;
  at[std::size_t(axes[1])] = halved ? 1 + 2 * (j >> 1) : 2;
  return at;
}

}  // namespace unsliver::octree
