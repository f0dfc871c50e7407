#include "octree/block.hpp"

namespace unsliver::octree {
namespace {

/// Where the cell at a place of a child block is found in the parent's: the neighbour of the parent, and
/// which of its children.
struct Origin {
  std::int8_t offset;
  std::uint8_t child;
};

constexpr std::array<Origin, 64> make_origins() {
  std::array<Origin, 64> origins{};
  for (int place = 0; place < 64; ++place) {
    const int step[3] = {(place & 3) - 1, (place >> 2 & 3) - 1, (place >> 4) - 1};
    int up[3] = {}, child = 0;
    for (int axis = 0; axis < 3; ++axis) {
      up[axis] = step[axis] < 0 ? -1 : step[axis] / 2;
      child |= (step[axis] & 1) << axis;
    }
    origins[std::size_t(place)] = {std::int8_t(offset(up[0], up[1], up[2])), std::uint8_t(child)};
  }
  return origins;
}
constexpr std::array<Origin, 64> kOrigins = make_origins();

}  // namespace

Block root_block(const Forest& forest, int i, int j, int k) {
  Block block;
  for (int place = 0; place < 64; ++place) {
    const int step[3] = {(place & 3) - 1, (place >> 2 & 3) - 1, (place >> 4) - 1};
    block.set(forest, place, forest.root(i + step[0], j + step[1], k + step[2]), true);
  }
  return block;
}

Block child_block(const Forest& forest, const Block& parent, int place) {
  Block block;
  for (int p = 0; p < 64; ++p) {
    const Origin origin = kOrigins[std::size_t(p)];
    const auto up = std::size_t(place + origin.offset);
    const bool is_split = (parent.split & parent.same) >> up & 1;
    block.set(forest, p, is_split ? parent.link[up] + origin.child : parent.node[up], is_split);
  }
  return block;
}

}  // namespace unsliver::octree
