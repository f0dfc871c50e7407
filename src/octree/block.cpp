#include "octree/block.hpp"

namespace unsliver::octree {
namespace {

/// Along one axis: the cell at coordinate 0..3 of a child block belongs to the parent's neighbour by -1, 0, 0
/// or 1, and is its upper, lower, upper or lower half.
constexpr int step_up(int coordinate) { return coordinate == 0 ? -1 : (coordinate - 1) / 2; }
constexpr int half(int coordinate) { return (coordinate + 1) & 1; }

constexpr std::array<Share, 27> make_shares() {
  std::array<Share, 27> shares{};
  for (int place = 0; place < 64; ++place) {
    const int at[3] = {place & 3, place >> 2 & 3, place >> 4};
    const int up[3] = {step_up(at[0]), step_up(at[1]), step_up(at[2])};
    const int number = (up[0] + 1) + 3 * (up[1] + 1) + 9 * (up[2] + 1);
    Share& share = shares[std::size_t(number)];
    share.offset = std::int8_t(offset(up[0], up[1], up[2]));
    share.place[share.count] = std::uint8_t(place);
    share.child[share.count++] = std::uint8_t(half(at[0]) | half(at[1]) << 1 | half(at[2]) << 2);
  }
  return shares;
}
}  // namespace

constexpr std::array<Share, 27> kShares = make_shares();

Block root_block(const Forest& forest, int i, int j, int k) {
  Block block;
  for (int place = 0; place < 64; ++place) {
    const NodeId n = forest.root(i + (place & 3) - 1, j + (place >> 2 & 3) - 1, k + (place >> 4) - 1);
    if (n == kNoNode)
      block.set_none(place);
    else
      block.set_same(place, n, forest[n]);
  }
  return block;
}

Block child_block(const Forest& forest, const Block& parent, int place) {
  Block block;
  for (const Share& share : kShares) {
    const int neighbor = place + share.offset;
    const auto up = std::size_t(neighbor);
    if (parent.split >> up & 1) {
      for (std::size_t i = 0; i < share.count; ++i) {
        const NodeId n = parent.link[up] + share.child[i];
        block.set_same(share.place[i], n, forest[n]);
      }
    } else {
      for (std::size_t i = 0; i < share.count; ++i) {
        if (parent.node[up] == kNoNode)
          block.set_none(share.place[i]);
        else
          block.set_larger_leaf(share.place[i], parent.node[up], parent.link[up]);
      }
    }
  }
  return block;
}

}  // namespace unsliver::octree
