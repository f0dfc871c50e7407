#include "octree/uniform.hpp"

namespace unsliver::octree {
namespace {

constexpr std::uint64_t kSelfAndNeighbors = [] {
  std::uint64_t mask = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) mask |= neighbor_bit(offset(x, y, z));
  return mask;
}();

Key uniform_key() {
  std::uint64_t bits = Key::center_bit();
  for (int face = 0; face < 6; ++face) bits |= Key::face_bits(face, kCentered, 0);
  return Key(bits);
}

/// The vertex at a slot of the leaf at a place, as in UniformPattern.
int vertex_number(int place, int slot) {
  if (slot == kCenterSlot) return 2 * place;
  if (slot >= kFirstBeyond) return 2 * (place + kFaceOffset[std::size_t(face_of_beyond(slot))]);
  return 2 * (place + octant_cell(slot, 7).offset) + 1;
}

}  // namespace

bool is_uniform(const Block& block, int place) {
  return (Block::around(block.uniform, place) & kSelfAndNeighbors) == kSelfAndNeighbors;
}

UniformPattern::UniformPattern() {
  const Template one = solve_template(uniform_key());
  for (int child = 0; child < 8; ++child)
    for (const auto& t : one.tets) {
      std::array<std::uint8_t, 4> corners;
      for (std::size_t i = 0; i < 4; ++i)
        corners[i] = std::uint8_t(vertex_number(place_of_child(child), t[i]));
      for (const std::uint8_t corner : corners) uses_[corner / 2] |= std::uint8_t(1 << corner % 2);
      tets_.push_back(corners);
    }
}

std::array<std::uint32_t, 4>* UniformPattern::write(const Forest& forest, const Block& block, int place,
                                                    std::array<std::uint32_t, 4>* out) const {
  std::array<std::uint32_t, 128> ids;
  for_each_child_place(block, place, [&](std::size_t at, NodeId leaf) {
    const auto first = std::uint32_t(~forest[leaf].link);
    ids[2 * at] = first;
    ids[2 * at + 1] = first + (forest[leaf].used & 1);  // a guest may have taken the centre
  });
  for (const auto& t : tets_) *out++ = {ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]]};
  return out;
}

}  // namespace unsliver::octree
