// Growth and balance by several threads: against a plain recursion, and the same for any number of threads.
#include "octree/growth.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "octree/balance.hpp"

namespace unsliver::octree {
namespace {

/// Most of the leaves are in a small part of the domain.
struct Job {
  DomainPtr domain = make_ball({0, 0, 0}, 1);
  SizingPtr size =
      graded_from_points({{0.21, 0.12, 0.33}}, {2e-4}, 0.06, std::numeric_limits<double>::infinity());
  lattice::World world = lattice::World::fit(domain->bounds(), 2e-4);
  LeafTest test{*domain, *size, world};
  Brick brick = brick_around(in_world(domain->bounds(), world));

  Forest grown(unsigned threads) const {
    Forest forest(brick);
    GrowthSettings settings;
    settings.threads = threads;
    grow(forest, test, settings);
    return forest;
  }

  Forest balanced(unsigned threads) const {
    Forest forest = grown(threads);
    LeafTest copy = test;
    balance(
        forest,
        [&](const Cell& cell) {
          for (int i = 0; i < 8; ++i) {
            Node& child = forest[forest.child(cell, i).node];
            child.flags = copy.flags(forest.child(cell, i), child.flags);
          }
        },
        threads);
    return forest;
  }
};

void grow_plainly(Forest& forest, LeafTest& test, const Cell& cell, std::uint8_t parent_flags) {
  const std::uint8_t flags = test.flags(cell, parent_flags);
  const Verdict verdict = test.judge(cell, flags);
  forest[cell.node].flags = std::uint8_t(flags | (verdict == Verdict::kWithCenter ? kHasCenter : 0));
  if (verdict != Verdict::kSplit) return;
  forest.split(cell.node);
  for (int child = 0; child < 8; ++child) grow_plainly(forest, test, forest.child(cell, child), flags);
}

/// What is below a cell, wherever the nodes lie.
void describe(const Forest& forest, const Cell& cell, std::vector<std::uint32_t>& out) {
  const Node& node = forest[cell.node];
  out.push_back(std::uint32_t(node.exponent) << 16 | std::uint32_t(node.flags) << 8 | node.is_leaf());
  if (node.is_leaf()) return;
  for (int child = 0; child < 8; ++child) describe(forest, forest.child(cell, child), out);
}

std::vector<std::uint32_t> describe(const Forest& forest) {
  std::vector<std::uint32_t> out;
  for_each_root(forest, [&](const Cell& root) { describe(forest, root, out); });
  return out;
}

void expect_same_nodes(const Forest& a, const Forest& b) {
  ASSERT_EQ(a.size(), b.size());
  for (NodeId n = 0; n < NodeId(a.size()); ++n) {
    ASSERT_EQ(a[n].link, b[n].link) << n;
    ASSERT_EQ(a[n].flags, b[n].flags) << n;
    ASSERT_EQ(a[n].exponent, b[n].exponent) << n;
    ASSERT_EQ(a[n].used, b[n].used) << n;
  }
}

TEST(Growth, AsByPlainRecursion) {
  const Job job;
  Forest plain(job.brick);
  LeafTest test = job.test;
  for_each_root(plain, [&](const Cell& root) { grow_plainly(plain, test, root, 0); });
  ASSERT_GT(plain.size(), 60'000u);
  EXPECT_EQ(describe(job.grown(1)), describe(plain));
}

TEST(Growth, SameNodesForAnyNumberOfThreads) {
  const Job job;
  const Forest one = job.grown(1);
  for (const unsigned threads : {2u, 5u}) expect_same_nodes(job.grown(threads), one);
}

TEST(Balance, SameNodesForAnyNumberOfThreads) {
  const Job job;
  const Forest one = job.balanced(1);
  EXPECT_GT(one.size(), job.grown(1).size());
  for (const unsigned threads : {2u, 5u}) expect_same_nodes(job.balanced(threads), one);
}

}  // namespace
}  // namespace unsliver::octree
