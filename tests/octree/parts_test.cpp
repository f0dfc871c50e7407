// Parts against a walk over the whole forest; sites against a search for each neighbour from the roots.
#include "octree/parts.hpp"

#include <gtest/gtest.h>

#include "random_forest.hpp"

namespace unsliver::octree {
namespace {

Forest large_forest(std::uint64_t seed) {
  test::ForestPlan plan = test::plan_of(seed);
  plan.brick.exponent = 20;
  plan.brick.lo = {0, -(std::int64_t{1} << 20), std::int64_t{1} << 22};
  plan.finest_exponent = 14;
  plan.split_chance = 0.5;
  return test::random_forest(plan, seed);
}

void walk(const Forest& forest, const Cell& cell, std::vector<NodeId>& nodes) {
  nodes.push_back(cell.node);
  if (forest[cell.node].is_leaf()) return;
  for (int child = 0; child < 8; ++child) walk(forest, forest.child(cell, child), nodes);
}

TEST(Parts, AllNodesDepthFirst) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Forest forest = large_forest(seed);
    std::vector<NodeId> all;
    for_each_root(forest, [&](const Cell& root) { walk(forest, root, all); });
    for (const std::size_t count : {1u, 3u, 64u}) {
      std::vector<NodeId> listed;
      for (const Part& part : cut(forest, count)) {
        std::vector<NodeId> nodes = {part.cell.node};
        if (part.whole) {
          nodes.clear();
          walk(forest, part.cell, nodes);
          EXPECT_LE(nodes.size(), std::max<std::size_t>(1024, forest.size() / count));
        }
        listed.insert(listed.end(), nodes.begin(), nodes.end());
      }
      EXPECT_EQ(listed, all);
    }
  }
}

TEST(Parts, LargeForestsAreCut) {
  const Forest forest = large_forest(1);
  ASSERT_GT(forest.size(), 20000u);
  EXPECT_GT(cut(forest, 64).size(), 16u);
}

/// The node that holds the cube of side 2^exponent at a corner, not below that size.
NodeId find(const Forest& forest, int exponent, const std::array<std::int64_t, 3>& corner) {
  NodeId found = kNoNode;
  for_each_root(forest, [&](const Cell& root) {
    Cell cell = root;
    const auto holds = [&](const Cell& c) {
      return c.x <= corner[0] && corner[0] < c.x + c.side() && c.y <= corner[1] &&
             corner[1] < c.y + c.side() && c.z <= corner[2] && corner[2] < c.z + c.side();
    };
    if (!holds(cell)) return;
    while (cell.exponent > exponent && !forest[cell.node].is_leaf())
      for (int child = 0; child < 8; ++child)
        if (const Cell c = forest.child(cell, child); holds(c)) {
          cell = c;
          break;
        }
    found = cell.node;
  });
  return found;
}

TEST(Parts, SitesKnowTheirNeighbors) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Forest forest = large_forest(seed);
    for (const Part& part : cut(forest, 64)) {
      const Cell& cell = part.cell;
      const Site site = site_of(forest, cell);
      for (int n = 0; n < 27; ++n) {
        const int dx = n % 3 - 1, dy = n / 3 % 3 - 1, dz = n / 9 - 1;
        const NodeId expected =
            find(forest, cell.exponent,
                 {cell.x + dx * cell.side(), cell.y + dy * cell.side(), cell.z + dz * cell.side()});
        EXPECT_EQ(site.block.node[std::size_t(site.place + offset(dx, dy, dz))], expected);
      }
    }
  }
}

}  // namespace
}  // namespace unsliver::octree
