#include "octree/growth.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "octree/parallel.hpp"
#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

constexpr std::uint64_t kPollInterval = 1024;  // nodes
constexpr std::size_t kSubtrees = 1024;
/// Beyond so many nodes, a subtree leaves what is open to others.
constexpr std::size_t kMostNodes = 1 << 14;

[[noreturn]] void refuse_tiny_size(const Cell& cell, const lattice::World& world) {
  const Vec3 p = world.to_caller(cell.center());
  Error error(ErrorCode::kLimit,
              fmt::format("the size asked for near ({}, {}, {}) is below {}, the finest that doubles can "
                          "represent across this domain; ask for larger sizes or move the domain nearer to "
                          "the origin",
                          p.x, p.y, p.z, lattice::kQuarterSqrt5 * double(cell.side()) * world.unit()));
  error.places.push_back(p);
  throw error;
}

struct Pending {
  Cell cell;
  std::uint8_t parent_flags;
};

/// Tells the caller how it goes, if this is its thread.
class Pulse {
 public:
  Pulse(const GrowthSettings& settings, std::atomic<std::uint64_t>& all_nodes, bool is_callers_thread)
      : settings_(settings), all_nodes_(all_nodes), is_callers_thread_(is_callers_thread) {}

  void beat() {
    if (++nodes_ % kPollInterval != 0) return;
    const std::uint64_t nodes = all_nodes_.fetch_add(kPollInterval) + kPollInterval;
    if (is_callers_thread_ && settings_.poll) settings_.poll(nodes * sizeof(Node));
  }

 private:
  const GrowthSettings& settings_;
  std::atomic<std::uint64_t>& all_nodes_;
  bool is_callers_thread_;
  std::uint64_t nodes_ = 0;
};

/// Grows one forest, breadth first or depth first.
class Growth {
 public:
  Growth(Forest& forest, LeafTest& test, bool all_centers, Pulse& pulse)
      : forest_(forest), test_(test), all_centers_(all_centers), pulse_(pulse) {}

  /// Decides on one node; returns whether it was split.
  bool judge(const Pending& at) {
    pulse_.beat();
    const Cell& cell = at.cell;
    const std::uint8_t flags = test_.flags(cell, at.parent_flags);
    const Verdict verdict = test_.judge(cell, flags);
    const bool with_center = verdict == Verdict::kWithCenter || all_centers_;
    forest_[cell.node].flags = std::uint8_t(flags | (with_center ? kHasCenter : 0));
    if (verdict != Verdict::kSplit) return false;
    if (2 * cell.exponent <= test_.world().finest_level() + 1) refuse_tiny_size(cell, test_.world());
    forest_.split(cell.node);
    return true;
  }

  /// Depth first; adds to `open` where it did not go on.
  void grow_subtree(const Pending& at, std::vector<Pending>& open) {
    if (forest_.size() > kMostNodes) return open.push_back(at);
    if (!judge(at)) return;
    const std::uint8_t flags = forest_[at.cell.node].flags;
    for (int child = 0; child < 8; ++child) grow_subtree({forest_.child(at.cell, child), flags}, open);
  }

  std::vector<Pending> grow_layer(const std::vector<Pending>& layer) {
    std::vector<Pending> next;
    for (const Pending& at : layer) {
      if (!judge(at)) continue;
      const std::uint8_t flags = forest_[at.cell.node].flags;
      for (int child = 0; child < 8; ++child) next.push_back({forest_.child(at.cell, child), flags});
    }
    return next;
  }

 private:
  Forest& forest_;
  LeafTest& test_;
  bool all_centers_;
  Pulse& pulse_;
};

/// A subtree, grown by itself.
struct Scion {
  std::optional<Forest> tree;
  std::vector<Pending> open;  ///< leaves still to be judged
  NodeId first = kNoNode;     ///< the room for it

  /// To be called when it is grafted.
  void renumber_open() {
    for (Pending& at : open) at.cell.node += first - 1;
  }
};

/// All threads at work on one forest.
class Nursery {
 public:
  Nursery(Forest& forest, const LeafTest& test, const GrowthSettings& settings)
      : forest_(forest), settings_(settings), tests_(settings.threads, test) {
    for (unsigned worker = 0; worker < settings.threads; ++worker)
      pulses_.emplace_back(settings_, all_nodes_, worker == 0);
  }

  // Layer by layer as long as there are few nodes, so that sizes that fail somewhere are found early; then
  // subtrees, each in a forest of its own.
  void run() {
    std::vector<Pending> open;
    for_each_root(forest_, [&](const Cell& root) { open.push_back({root, settings_.root_flags}); });
    Growth top = growth(forest_, 0);
    while (!open.empty() && open.size() < kSubtrees) open = top.grow_layer(open);
    while (!open.empty()) open = grow_subtrees(open);
  }

  LeafTestCounts counts() const {
    LeafTestCounts sum;
    for (const LeafTest& test : tests_) sum += test.counts();
    return sum;
  }

 private:
  Growth growth(Forest& forest, unsigned worker) {
    return {forest, tests_[worker], settings_.all_centers, pulses_[worker]};
  }

  /// Returns what is still open.
  std::vector<Pending> grow_subtrees(const std::vector<Pending>& roots) {
    std::vector<Scion> scions(roots.size());
    for_each_task(roots.size(), settings_.threads, [&](std::size_t i, unsigned worker) {
      Cell cell = roots[i].cell;
      Forest& tree = scions[i].tree.emplace(Brick{cell.exponent, {cell.x, cell.y, cell.z}, {1, 1, 1}});
      cell.node = 0;
      growth(tree, worker).grow_subtree({cell, roots[i].parent_flags}, scions[i].open);
    });
    std::size_t nodes = 0;
    for (const Scion& scion : scions) nodes += scion.tree->size() - 1;
    NodeId first = forest_.make_room(nodes);
    for (Scion& scion : scions) scion.first = std::exchange(first, first + NodeId(scion.tree->size() - 1));
    for_each_task(roots.size(), settings_.threads, [&](std::size_t i, unsigned) {
      forest_.graft(roots[i].cell.node, *scions[i].tree, scions[i].first);
      scions[i].renumber_open();
      scions[i].tree.reset();
    });
    std::vector<Pending> open;
    for (const Scion& scion : scions) open.insert(open.end(), scion.open.begin(), scion.open.end());
    return open;
  }

  Forest& forest_;
  const GrowthSettings& settings_;
  std::vector<LeafTest> tests_;
  std::atomic<std::uint64_t> all_nodes_{0};
  std::vector<Pulse> pulses_;
};

}  // namespace

Box3 in_world(const Box3& box, const lattice::World& world) {
  return {world.to_world_real(box.lo), world.to_world_real(box.hi)};
}

Brick brick_around(const Box3& box) {
  Brick brick{};
  brick.exponent = std::max(1, std::ilogb(box.longest_side()) + 1);
  const double side = std::ldexp(1.0, brick.exponent);
  for (int axis = 0; axis < 3; ++axis) {
    const double first = std::floor(box.lo[axis] / side) - 1, last = std::ceil(box.hi[axis] / side) + 1;
    brick.lo[std::size_t(axis)] = std::int64_t(first * side);
    brick.count[std::size_t(axis)] = int(last - first);
  }
  return brick;
}

LeafTestCounts grow(Forest& forest, const LeafTest& test, const GrowthSettings& settings) {
  Nursery nursery(forest, test, settings);
  nursery.run();
  return nursery.counts();
}

}  // namespace unsliver::octree
