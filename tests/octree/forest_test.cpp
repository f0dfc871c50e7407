// Tetrahedra from templates against those of the kernel, on random balanced forests.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "delaunay/triangulation.hpp"
#include "exact/quality_signs.hpp"
#include "lattice/parents.hpp"
#include "octree/random_forest.hpp"

namespace unsliver::octree {
namespace {

using test::as_tets;
using test::emit;
using test::plan_of;
using test::PointsAndTets;
using test::random_forest;
using test::sorted;

std::uint64_t forest_count() { return std::getenv("UNSLIVER_LONG") != nullptr ? 1000 : 72; }

std::vector<Tet> delaunay_tets(const std::vector<Vec3>& points) {
  delaunay::Triangulation dt;
  dt.insert_all(points);
  std::vector<Tet> tets;
  for (delaunay::TetId t = 0; t < dt.slot_count(); ++t)
    if (dt.is_finite(t)) tets.push_back(dt.corners(t));
  return tets;
}

double volume_times_6(const Tet& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])); }

double volume(const Brick& brick) {
  return std::ldexp(double(brick.count[0]) * brick.count[1] * brick.count[2], 3 * brick.exponent);
}

struct LexLess {
  bool operator()(const Vec3& a, const Vec3& b) const { return lex_less(a, b); }
};

bool in_brick(const Brick& brick, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = double(brick.lo[std::size_t(axis)]);
    const double side = std::ldexp(double(brick.count[std::size_t(axis)]), brick.exponent);
    if (p[axis] < lo || p[axis] > lo + side) return false;
  }
  return true;
}

TEST(Forest, TetrahedraAreThoseOfTheKernelTiesIncluded) {
  std::size_t tets = 0;
  for (std::uint64_t seed = 1; seed <= forest_count(); ++seed) {
    SCOPED_TRACE("forest " + std::to_string(seed));
    Forest forest = random_forest(plan_of(seed), seed);
    const PointsAndTets mesh = emit(forest);
    tets += mesh.tets.size();
    ASSERT_EQ(sorted(as_tets(mesh)), sorted(delaunay_tets(mesh.points)));
  }
  EXPECT_GT(tets, 100'000u);
}

TEST(Forest, TetrahedraAreGoodAndFillTheBrick) {
  exact::StageCounts counts;
  for (std::uint64_t seed = 1; seed <= forest_count(); ++seed) {
    SCOPED_TRACE("forest " + std::to_string(seed));
    Forest forest = random_forest(plan_of(seed), seed);
    double total = 0;
    for (const Tet& t : as_tets(emit(forest))) {
      EXPECT_GT(exact::orient3d(t[0], t[1], t[2], t[3], counts), 0);
      EXPECT_FALSE(exact::is_bad(t, {}, counts));
      total += volume_times_6(t);
    }
    EXPECT_EQ(total, 6 * volume(forest.brick()));
  }
}

TEST(Forest, PointsHoldTheirParentsInTheBrick) {
  for (std::uint64_t seed = 1; seed <= forest_count(); ++seed) {
    SCOPED_TRACE("forest " + std::to_string(seed));
    Forest forest = random_forest(plan_of(seed), seed);
    const std::vector<Vec3> points = emit(forest).points;
    const std::set<Vec3, LexLess> set(points.begin(), points.end());
    EXPECT_EQ(set.size(), points.size());
    for (const Vec3& v : points) {
      if (lattice::canonical_level(v) > 2 * forest.brick().exponent) continue;
      for (const Vec3& parent : lattice::Parents(v))
        EXPECT_TRUE(!in_brick(forest.brick(), parent) || set.contains(parent));
    }
  }
}

// Large uniform parts take a way of their own (octree/uniform.hpp).
TEST(Forest, UniformPartsHaveTheSameTetrahedra) {
  for (const bool with_fine_corner : {false, true}) {
    const test::ForestPlan plan{{6, {64, -64, 0}, {1, 1, 1}}, 3, 1.0, 1.0};
    Forest forest = random_forest(plan, 1);
    if (with_fine_corner) {
      NodeId leaf = 0;
      while (!forest[leaf].is_leaf()) leaf = forest[leaf].link;
      forest.split(forest.split(leaf));
      balance(forest, [](const Cell&) {});
    }
    const PointsAndTets mesh = emit(forest);
    EXPECT_GT(mesh.tets.size(), 8u * 8 * 8 * 12 - 8u * 8 * 6 * 3);
    EXPECT_EQ(sorted(as_tets(mesh)), sorted(delaunay_tets(mesh.points)));
  }
}

TEST(Forest, ThreadsChangeNothing) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("forest " + std::to_string(seed));
    Forest a = random_forest(plan_of(seed), seed), b = random_forest(plan_of(seed), seed);
    const PointsAndTets one = emit(a, 1), three = emit(b, 3);
    EXPECT_EQ(one.points, three.points);
    EXPECT_EQ(one.tets, three.tets);
  }
}

}  // namespace
}  // namespace unsliver::octree
