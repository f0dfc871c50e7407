#include "octree/balance.hpp"

#include <atomic>
#include <vector>

#include "octree/parallel.hpp"
#include "octree/parts.hpp"
#include "octree/slots.hpp"

namespace unsliver::octree {
namespace {

constexpr std::size_t kPartsPerThread = 64;

/// What a sweep finds in a part of the forest.
struct Findings {
  struct Gap {
    Cell cell;
    std::uint64_t neighbors;  ///< that have to be there in the cell's own size, and are not
  };
  std::vector<Gap> gaps;
  std::vector<NodeId> hanging;  ///< leaves with a hanging vertex, but without a centre
};

/// Looks at all nodes with children. Changes nothing, so that threads can look at the same time.
class Sweep {
 public:
  Sweep(const Forest& forest, Findings& found) : forest_(forest), found_(found) {}

  void run(const Part& part) {
    if (forest_[part.cell.node].is_leaf()) return;
    const Site site = site_of(forest_, part.cell);
    look(site.block, site.place, part.cell);
    if (part.whole) visit_children(site.block, site.place, part.cell);
  }

 private:
  /// A node's neighbours across faces and edges must be there in its own size, and those of them that are
  /// leaves have a hanging vertex.
  void look(const Block& block, int place, const Cell& cell) {
    const std::uint64_t exists = Block::around(block.exists, place);
    const std::uint64_t same = Block::around(block.same, place);
    const std::uint64_t missing = exists & ~same & kFaceAndEdgeNeighbors;
    if (missing != 0) found_.gaps.push_back({cell, missing});
    const std::uint64_t split_or_centered = Block::around(block.split | block.centered, place);
    for (std::uint64_t hanging = same & ~split_or_centered & kFaceAndEdgeNeighbors; hanging != 0;
         hanging &= hanging - 1) {
      const int at = place - kFirstPlace + std::countr_zero(hanging);
      found_.hanging.push_back(block.node[std::size_t(at)]);
    }
  }

  void visit_children(const Block& block, int place, const Cell& cell) {
    if (!has_grandchildren(cell)) return;
    const Block inner = child_block(forest_, block, place);
    for (int child = 0; child < 8; ++child) {
      const Cell c = forest_.child(cell, child);
      if (forest_[c.node].is_leaf()) continue;
      look(inner, place_of_child(child), c);
      visit_children(inner, place_of_child(child), c);
    }
  }

  bool has_grandchildren(const Cell& cell) const {
    const NodeId first = forest_[cell.node].link;
    for (NodeId n = first; n < first + 8; ++n)
      if (!forest_[n].is_leaf()) return true;
    return false;
  }

  const Forest& forest_;
  Findings& found_;
};

/// Fills the gaps, and those that this opens.
class Splitter {
 public:
  Splitter(Forest& forest, const std::function<void(const Cell&)>& on_split)
      : forest_(forest), on_split_(on_split) {}

  /// Makes the neighbours of the mask exist in the cell's own size.
  void require(std::uint64_t neighbors, const Cell& cell) {
    for (; neighbors != 0; neighbors &= neighbors - 1) {
      const int place = std::countr_zero(neighbors);
      const std::int64_t s = cell.side();
      split_down_to({kNoNode, cell.exponent, cell.x + ((place & 3) - 1) * s,
                     cell.y + ((place >> 2 & 3) - 1) * s, cell.z + ((place >> 4) - 1) * s});
    }
  }

  std::uint64_t splits() const { return splits_; }

 private:
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

/// Notes below a node which nodes are uniform.
void note_uniformity(Forest& forest, NodeId n, bool whole) {
  constexpr std::uint8_t kPlainBulk = kHasCenter | kInside;
  if (forest[n].is_leaf()) return;
  bool uniform = true;
  const NodeId first = forest[n].link;
  for (NodeId child = first; child < first + 8; ++child) {
    const bool is_leaf = forest[child].is_leaf();
    uniform = uniform && is_leaf && (forest[child].flags & kPlainBulk) == kPlainBulk;
    if (whole && !is_leaf) note_uniformity(forest, child, true);
  }
  std::uint8_t& flags = forest[n].flags;
  flags = std::uint8_t(uniform ? flags | kUniform : flags & ~kUniform);
}

/// A forest's parts, which stay its parts when leaves are split, and the threads that work on them.
class Balancing {
 public:
  Balancing(Forest& forest, unsigned threads)
      : forest_(forest), threads_(threads), parts_(cut(forest, kPartsPerThread * threads)) {}

  /// Sweeps do not see each other's splits: the last one, without any, finds all that hangs.
  std::uint64_t run(const std::function<void(const Cell&)>& on_split) {
    Splitter splitter(forest_, on_split);
    std::uint64_t old_splits;
    do {
      sweep();
      old_splits = splitter.splits();
      for (const Findings& found : found_)
        for (const auto& gap : found.gaps) splitter.require(gap.neighbors, gap.cell);
    } while (splitter.splits() != old_splits);
    add_centers();
    for_each_part([this](std::size_t i) { note_uniformity(forest_, parts_[i].cell.node, parts_[i].whole); });
    return splitter.splits();
  }

 private:
  template <class Work>
  void for_each_part(const Work& work) {
    for_each_task(parts_.size(), threads_, [&](std::size_t i, unsigned) { work(i); });
  }

  void sweep() {
    found_.assign(parts_.size(), {});
    for_each_part([this](std::size_t i) { Sweep(forest_, found_[i]).run(parts_[i]); });
  }

  /// Several parts may name the same leaf.
  void add_centers() {
    for_each_part([this](std::size_t i) {
      for (const NodeId leaf : found_[i].hanging)
        std::atomic_ref(forest_[leaf].flags).fetch_or(kHasCenter, std::memory_order_relaxed);
    });
  }

  Forest& forest_;
  const unsigned threads_;
  const std::vector<Part> parts_;
  std::vector<Findings> found_;
};

}  // namespace

std::uint64_t balance(Forest& forest, const std::function<void(const Cell&)>& on_split, unsigned threads) {
  return Balancing(forest, threads).run(on_split);
}

}  // namespace unsliver::octree
