#include "lattice/parents.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference.hpp"

namespace unsliver::lattice {
namespace {

using reference::Random;
using reference::to_vec;

struct LexLess {
  bool operator()(const Vec3& a, const Vec3& b) const { return lex_less(a, b); }
};
using PointSet = std::set<Vec3, LexLess>;

PointSet as_set(const Parents& parents) { return {parents.begin(), parents.end()}; }

/// By another definition: the points q of the next coarser lattice that are nearest to v (six or eight
/// within spacing * sqrt 2 or spacing * sqrt 3, spacing being that of v's cubes), found by search.
PointSet parents_by_search(const Vec3& v) {
  const Level level = canonical_level(v);
  const double step = power_of_two(region_exponent(level));
  const double reach_sq = (is_bcc(level) ? 3 : 2) * step * step;
  PointSet found;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        const Vec3 d = step * Vec3{double(x), double(y), double(z)};
        if (norm_sq(d) > 0 && norm_sq(d) <= reach_sq && on_lattice(level + 1, v + d)) found.insert(v + d);
      }
  return found;
}

Vec3 random_point(Random& random) {
  for (;;) {
    const Vec3 v = to_vec(random.lattice_point(Level(random.integer(kMinLevel, 90))));
    if (canonical_level(v) <= 92) return v;
  }
}

TEST(Parents, AreThePointsOfTheNextCoarserLatticeAroundThePoint) {
  Random random(1);
  for (int i = 0; i < 50'000; ++i) {
    const Vec3 v = random_point(random);
    const Parents parents(v);
    EXPECT_EQ(parents.size(), is_bcc(canonical_level(v)) ? 8u : 6u) << v;
    EXPECT_EQ(as_set(parents), parents_by_search(v)) << v;
  }
}

TEST(Parents, OfTheMiddlesOfEdgesAndFaces) {
  EXPECT_EQ(as_set(Parents({1, 0, 0})),
            (PointSet{{0, 0, 0}, {2, 0, 0}, {1, -1, -1}, {1, -1, 1}, {1, 1, -1}, {1, 1, 1}}));
  EXPECT_EQ(as_set(Parents({1, 1, 0})),
            (PointSet{{1, 1, -1}, {1, 1, 1}, {0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 0}}));
  EXPECT_EQ(
      as_set(Parents({2, 2, 2})),
      (PointSet{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {0, 0, 4}, {4, 0, 4}, {0, 4, 4}, {4, 4, 4}}));
}

TEST(Parents, MoveWithTheLatticeAndScaleWithIt) {
  Random random(2);
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 v = to_vec(random.point(1000));
    if (v == Vec3{}) continue;
    const Vec3 shift = 0x1p40 * to_vec(random.point(3));
    PointSet moved, scaled;
    for (const Vec3& p : Parents(v)) moved.insert(p + shift), scaled.insert(8 * p);
    EXPECT_EQ(as_set(Parents(v + shift)), moved) << v;
    EXPECT_EQ(as_set(Parents(8 * v)), scaled) << v;
  }
}

bool is_closed(const PointSet& set, Level coarsest) {
  for (const Vec3& v : set) {
    if (canonical_level(v) >= coarsest) continue;
    for (const Vec3& p : Parents(v))
      if (!set.contains(p)) return false;
  }
  return true;
}

TEST(Closure, IsClosedSmallestAndSorted) {
  Random random(3);
  const Level coarsest = 9;
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) points.push_back(to_vec(random.point(40)));
    const std::vector<Vec3> closed = closure(points, coarsest);
    EXPECT_TRUE(std::is_sorted(closed.begin(), closed.end(), lex_less));
    PointSet set(closed.begin(), closed.end());
    EXPECT_EQ(set.size(), closed.size());
    for (const Vec3& p : points) EXPECT_TRUE(set.contains(p)) << p;
    EXPECT_TRUE(is_closed(set, coarsest));
    EXPECT_EQ(closure(closed, coarsest), closed);
    // Smallest: what is not asked for is the parent of something.
    PointSet needed(points.begin(), points.end());
    for (const Vec3& v : closed)
      if (canonical_level(v) < coarsest)
        for (const Vec3& p : Parents(v)) needed.insert(p);
    EXPECT_EQ(needed, set);
  }
}

}  // namespace
}  // namespace unsliver::lattice
