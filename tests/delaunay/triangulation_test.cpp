#include "delaunay/triangulation.hpp"

#include <gtest/gtest.h>

#include <set>

#include "delaunay/point_sets.hpp"

namespace unsliver::delaunay {
namespace {

using test::Random;

// A tetrahedron is compared as its four positions in lexicographic order: independent of ids and slots.
struct TetLess {
  bool operator()(const Tet& a, const Tet& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lex_less);
  }
};
using TetSet = std::set<Tet, TetLess>;

TetSet tet_set(const Triangulation& dt) {
  TetSet result;
  for (TetId t = 0; t < dt.slot_count(); ++t) {
    if (!dt.is_finite(t)) continue;
    Tet corners = dt.corners(t);
    std::sort(corners.begin(), corners.end(), lex_less);
    result.insert(corners);
  }
  return result;
}

Triangulation build(const std::vector<Vec3>& points) {
  Triangulation dt;
  for (const Vec3& p : points) dt.insert(p);
  return dt;
}

std::size_t distinct(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), lex_less);
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

TEST(Triangulation, KeepsItsInvariantsOnEveryKindOfPointSet) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const auto& set : test::point_sets(seed)) {
      SCOPED_TRACE(set.name + ", seed " + std::to_string(seed));
      const Triangulation dt = build(set.points);
      EXPECT_EQ(dt.dimension(), 3);
      EXPECT_EQ(dt.vertex_count(), distinct(set.points));
      EXPECT_NO_THROW(dt.check());
    }
}

TEST(Triangulation, IsAFunctionOfThePointSetAlone) {
  for (const auto& set : test::point_sets(7)) {
    SCOPED_TRACE(set.name);
    const TetSet expected = tet_set(build(set.points));
    EXPECT_FALSE(expected.empty());
    Random random(11);
    for (int trial = 0; trial < 4; ++trial) {
      std::vector<Vec3> shuffled = set.points;
      test::shuffle(shuffled, random);
      EXPECT_EQ(tet_set(build(shuffled)), expected) << "shuffle " << trial;
    }
    Triangulation bulk;
    bulk.insert_all(set.points);
    EXPECT_EQ(tet_set(bulk), expected) << "bulk insertion";
  }
}

TEST(Triangulation, IsInvariantUnderTranslationAndDyadicScaling) {
  for (const auto& set : test::point_sets(5)) {
    SCOPED_TRACE(set.name);
    const Vec3 shift{12345, -678, 91011};
    std::vector<Vec3> moved;
    for (const Vec3& p : set.points) moved.push_back(p + shift);
    TetSet back;
    for (Tet t : tet_set(build(moved))) {
      for (Vec3& p : t) p = p - shift;
      back.insert(t);
    }
    EXPECT_EQ(back, tet_set(build(set.points)));
  }
}

TEST(Triangulation, ReturnsTheExistingVertexForADuplicate) {
  Triangulation dt;
  const std::vector<Vec3> cube = test::lattice_points(2, 8, true);
  const std::vector<VertexId> first = dt.insert_all(cube);
  const std::size_t tets = dt.tet_count();
  EXPECT_EQ(dt.insert_all(cube), first);
  EXPECT_EQ(dt.tet_count(), tets);
}

TEST(Triangulation, HasNoTetrahedraBelowDimensionThree) {
  Triangulation dt;
  EXPECT_EQ(dt.dimension(), -1);
  const VertexId a = dt.insert({5, 5, 5});
  EXPECT_EQ(dt.dimension(), 0);
  EXPECT_EQ(dt.insert({5, 5, 5}), a);
  dt.insert({6, 6, 6});
  dt.insert({9, 9, 9});
  EXPECT_EQ(dt.dimension(), 1);
  dt.insert({9, 9, 8});
  dt.insert({5, 5, 2});
  EXPECT_EQ(dt.dimension(), 2);
  EXPECT_EQ(dt.vertex_count(), 5u);
  EXPECT_EQ(dt.tet_count(), 0u);
  dt.insert({0, 1, 0});
  EXPECT_EQ(dt.dimension(), 3);
  EXPECT_NO_THROW(dt.check());
}

// A vertex of degree n + 2: each insertion near the axis rebuilds a cavity of hundreds of facets, beyond the
// flat edge table.
TEST(Triangulation, FillsCavitiesOfAnySize) {
  Triangulation dt;
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) {
    const double angle = i * 2.399963;
    points.push_back({std::floor(1e9 * std::cos(angle) + 0.5), std::floor(1e9 * std::sin(angle) + 0.5),
                      test::uniform_integer(random, 1e5)});
  }
  for (const Vec3& p : points) dt.insert(p);
  dt.insert({0, 0, 40000000});
  EXPECT_GT(dt.created().size(), 2 * EdgeMap::kSmall);
  EXPECT_NO_THROW(dt.check());
}

TEST(Triangulation, AbandonLeavesNoTrace) {
  Random random(9);
  Triangulation dt;
  dt.insert_all(test::uniform_points(300, 0x1p30, random));
  const TetSet before = tet_set(dt);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = test::uniform_point(random, 0x1p30);
    dt.carve(p, dt.locate(p));
    dt.abandon();
  }
  EXPECT_EQ(tet_set(dt), before);
  dt.insert(test::uniform_point(random, 0x1p30));
  EXPECT_NO_THROW(dt.check());
}

TEST(Triangulation, ReusesFreedSlots) {
  Random random(4);
  Triangulation dt;
  dt.insert_all(test::uniform_points(20000, 0x1p40, random));
  EXPECT_LT(dt.slot_count(), dt.tet_count() + dt.tet_count() / 100);
}

TEST(Triangulation, DecidesLatticeTiesWithoutWideArithmetic) {
  for (const bool centres : {false, true}) {
    Triangulation dt;
    dt.insert_all(test::lattice_points(12, 0x1p20, centres));
    const auto& counts = dt.counts().conflict;
    EXPECT_EQ(counts.wide, 0u);
    EXPECT_GT(counts.tie, 1000u);
    RecordProperty(centres ? "bcc_ties" : "sc_ties", static_cast<int>(counts.tie));
  }
}

}  // namespace
}  // namespace unsliver::delaunay
