#include "octree/balance.hpp"

#include "octree/slots.hpp"

namespace unsliver::octree {
namespace {

/// One sweep over all nodes with children. Blocks do not see the splits of the sweep itself: the last sweep,
/// without any, sets the centres that are still missing.
class Sweep {
 public:
  Sweep(Forest& forest, const std::function<void(const Cell&)>& on_split)
      : forest_(forest), on_split_(on_split) {}

  std::uint64_t run() {
    const auto count = forest_.brick().count;
    for (int k = 0; k < count[2]; ++k)
      for (int j = 0; j < count[1]; ++j)
        for (int i = 0; i < count[0]; ++i) {
          const Cell root = forest_.root_cell(i, j, k);
          if (!forest_[root.node].is_leaf()) visit(root_block(forest_, i, j, k), kFirstPlace, root);
        }
    return splits_;
  }

 private:
  /// A node with children: its neighbours across faces and edges must be there in its own size, and those of
  /// them that are leaves have a hanging vertex.
  void visit(const Block& block, int place, const Cell& cell) {
    const std::uint64_t exists = Block::around(block.exists, place);
    const std::uint64_t same = Block::around(block.same, place);
    const std::uint64_t missing = exists & ~same & kFaceAndEdgeNeighbors;
    require(missing, cell);
    for (std::uint64_t leaves = same & ~Block::around(block.split, place) & kFaceAndEdgeNeighbors;
         leaves != 0; leaves &= leaves - 1) {
      const int at = place - kFirstPlace + std::countr_zero(leaves);
      forest_[block.node[std::size_t(at)]].flags |= kHasCenter;
    }
    note_uniformity(cell);
    if (!has_grandchildren(cell)) return;
    const Block inner = child_block(forest_, block, place);
    for (int child = 0; child < 8; ++child) {
      const Cell c = forest_.child(cell, child);
      if (!forest_[c.node].is_leaf()) visit(inner, place_of_child(child), c);
    }
  }

  void note_uniformity(const Cell& cell) {
    constexpr std::uint8_t kPlainBulk = kHasCenter | kInside;
    const NodeId first = forest_[cell.node].link;
    bool uniform = true;
    for (NodeId n = first; n < first + 8; ++n)
      uniform = uniform && forest_[n].is_leaf() && (forest_[n].flags & kPlainBulk) == kPlainBulk;
    std::uint8_t& flags = forest_[cell.node].flags;
    flags = std::uint8_t(uniform ? flags | kUniform : flags & ~kUniform);
  }

  bool has_grandchildren(const Cell& cell) const {
    const NodeId first = forest_[cell.node].link;
    for (NodeId n = first; n < first + 8; ++n)
      if (!forest_[n].is_leaf()) return true;
    return false;
  }

  /// Makes the neighbours of the mask exist in the cell's own size.
  void require(std::uint64_t neighbors, const Cell& cell) {
    for (; neighbors != 0; neighbors &= neighbors - 1) {
      const int place = std::countr_zero(neighbors);
      const std::int64_t s = cell.side();
      split_down_to({kNoNode, cell.exponent, cell.x + ((place & 3) - 1) * s,
                     cell.y + ((place >> 2 & 3) - 1) * s, cell.z + ((place >> 4) - 1) * s});
    }
  }

  void split_down_to(const Cell& wanted) {
    Cell cell = root_around(wanted);
    while (cell.node != kNoNode && cell.exponent > wanted.exponent) {
      if (forest_[cell.node].is_leaf()) split(cell);
      const int k = cell.exponent - 1;
      cell = forest_.child(cell, int((wanted.x - cell.x) >> k | (wanted.y - cell.y) >> k << 1 |
                                     (wanted.z - cell.z) >> k << 2));
    }
  }

  Cell root_around(const Cell& cell) const {
    const Brick& brick = forest_.brick();
    const auto number = [&](std::size_t axis, std::int64_t at) {
      return int((at - brick.lo[axis]) >> brick.exponent);
    };
    return forest_.root_cell(number(0, cell.x), number(1, cell.y), number(2, cell.z));
  }

  void split(const Cell& cell) {
    forest_.split(cell.node);
    on_split_(cell);
    ++splits_;
    require(kFaceAndEdgeNeighbors, cell);
  }

  Forest& forest_;
  const std::function<void(const Cell&)>& on_split_;
  std::uint64_t splits_ = 0;
};

}  // namespace

std::uint64_t balance(Forest& forest, const std::function<void(const Cell&)>& on_split) {
  std::uint64_t total = 0;
  for (std::uint64_t splits = 1; splits != 0; total += splits) splits = Sweep(forest, on_split).run();
  return total;
}

}  // namespace unsliver::octree
