/// Signs of degree 8 against unlimited integers; tetrahedra exactly at a bound and one unit beyond.
#include "exact/quality_signs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "generators.hpp"
#include "reference.hpp"

namespace unsliver::exact {
namespace {

using reference::compare_dihedral;
using reference::compare_radius_edge;

const std::vector<CosBound> kAngles = {{1, 3, 4},        {-1, 1, 2},       {1, 1, 2},
                                       {0, 0, 1},        {-1, 3, 4},       {1, 1048574, 1048575},
                                       {-1, 1, 1048575}, {1, 7919, 104729}};
const std::vector<RatioBound> kRatios = {{5, 4}, {1, 2}, {3, 8}, {1048575, 1}, {104729, 7919}};

Tet positive(Tet t, StageCounts& counts) {
  if (orient3d(t[0], t[1], t[2], t[3], counts) < 0) std::swap(t[0], t[1]);
  return t;
}

bool is_flat(const Tet& t, StageCounts& counts) { return orient3d(t[0], t[1], t[2], t[3], counts) == 0; }

bool reference_is_bad(const Tet& t, const QualityBounds& b) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const CosBound &low = b.min_dihedral, &high = b.max_dihedral;
      if (compare_dihedral(t, i, j, low.sign, low.num, low.den) < 0) return true;
      if (compare_dihedral(t, i, j, high.sign, high.num, high.den) > 0) return true;
    }
  return compare_radius_edge(t, b.max_radius_edge.num, b.max_radius_edge.den) > 0;
}

/// All signs of one tetrahedron against the reference.
void check(Tet t, StageCounts& counts) {
  StageCounts ignored;
  if (is_flat(t, ignored)) return;
  t = positive(t, ignored);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (const CosBound& b : kAngles) {
        if (i == j) continue;
        ASSERT_EQ(compare_dihedral(t, i, j, b, counts),
                  compare_dihedral(t, static_cast<std::size_t>(i), static_cast<std::size_t>(j), b.sign, b.num,
                                   b.den));
      }
  for (const RatioBound& b : kRatios)
    ASSERT_EQ(compare_radius_edge(t, b, counts), compare_radius_edge(t, b.num, b.den));
  const QualityBounds paper, loose{{1, 1048574, 1048575}, {-1, 1048574, 1048575}, {1048575, 1}};
  ASSERT_EQ(is_bad(t, paper, counts), reference_is_bad(t, paper));
  ASSERT_EQ(is_bad(t, loose, counts), reference_is_bad(t, loose));
}

TEST(QualitySigns, RandomTetrahedraOfAllMagnitudes) {
  SCOPED_TRACE("seed 1");
  Generator random(1);
  StageCounts counts;
  for (int n = 0; n < 1200; ++n) ASSERT_NO_FATAL_FAILURE(check(random.vectors<4>(1 + n % 48), counts));
}

TEST(QualitySigns, SliversAndNeedlesOfAllMagnitudes) {
  SCOPED_TRACE("seed 2");
  Generator random(2);
  StageCounts counts;
  for (int n = 0; n < 400; ++n) {
    Tet flat = random.coplanar<4>(1 + n % 22);
    random.nudge(flat);
    ASSERT_NO_FATAL_FAILURE(check(flat, counts));
    Tet needle = random.vectors<4>(1 + n % 48);
    needle[1] = needle[0];
    random.nudge(needle);
    ASSERT_NO_FATAL_FAILURE(check(needle, counts));
  }
  EXPECT_GT(counts.wide, 0U);
}

TEST(QualitySigns, LatticeTetrahedraNeverNeedWideIntegers) {
  SCOPED_TRACE("seed 3");
  Generator random(3);
  StageCounts counts;
  for (int n = 0; n < 1200; ++n)
    ASSERT_NO_FATAL_FAILURE(check(random.lattice<4>(2 + n % 3, std::ldexp(1.0, 1 + n % 38), n % 2), counts));
  EXPECT_EQ(counts.wide, 0U);
  EXPECT_GT(counts.small, 100U);
}

/// Four at a time, to the last bit of the radius, and the rest of a batch one by one.
TEST(QualitySigns, ManyAreJudgedAsEachAlone) {
  SCOPED_TRACE("seed 4");
  Generator random(4);
  StageCounts alone, batched, ignored;
  for (int n = 0; n < 300; ++n) {
    std::vector<Tet> tets;
    while (tets.size() < static_cast<std::size_t>(n % 11)) {
      const Tet t = tets.size() % 2 == 0 ? random.vectors<4>(1 + n % 48)
                                         : random.lattice<4>(2 + n % 3, std::ldexp(1.0, 1 + n % 38), n % 2);
      if (!is_flat(t, ignored)) tets.push_back(positive(t, ignored));
    }
    std::vector<Judgement> judgements(tets.size());
    judge(tets, QualityBounds(), batched, judgements);
    for (std::size_t i = 0; i < tets.size(); ++i) {
      const Judgement expected = judge(tets[i], QualityBounds(), alone);
      ASSERT_EQ(judgements[i].is_bad, expected.is_bad);
      ASSERT_EQ(judgements[i].radius_sq, expected.radius_sq);
    }
  }
  EXPECT_EQ(batched.filter, alone.filter);
  EXPECT_EQ(batched.small, alone.small);
  EXPECT_EQ(batched.wide, alone.wide);
  EXPECT_GT(alone.small, 0U);
}

/// All tetrahedra with a corner at 0 and the others in {-1, .., 2} x {0, .., 2}^2.
std::vector<Tet> small_tetrahedra() {
  std::vector<Vec3> points;
  for (int x = -1; x <= 2; ++x)
    for (int y = 0; y <= 2; ++y)
      for (int z = 0; z <= 2; ++z)
        if (x != 0 || y != 0 || z != 0) points.push_back({double(x), double(y), double(z)});
  std::vector<Tet> tets;
  StageCounts counts;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (std::size_t c = 0; c < b; ++c) {
        const Tet t = {Vec3{0, 0, 0}, points[a], points[b], points[c]};
        if (!is_flat(t, counts)) tets.push_back(positive(t, counts));
      }
  return tets;
}

struct AtBounds {
  int min_angle = 0, max_angle = 0, ratio = 0;
};

AtBounds at_bounds(const Tet& t, const QualityBounds& b, StageCounts& counts) {
  AtBounds at;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      at.min_angle += compare_dihedral(t, i, j, b.min_dihedral, counts) == 0;
      at.max_angle += compare_dihedral(t, i, j, b.max_dihedral, counts) == 0;
    }
  at.ratio = compare_radius_edge(t, b.max_radius_edge, counts) == 0;
  return at;
}

Tet scaled(Tet t, double factor) {
  for (Vec3& p : t) p = factor * p;
  return t;
}

/// At 30 or 135 degrees or sqrt(5)/2 exactly: good. Of their 24 neighbours by one unit some are bad.
TEST(QualitySigns, AtABoundIsGoodAndOneUnitBeyondIsBad) {
  const QualityBounds bounds;
  StageCounts counts;
  AtBounds seen, beyond;
  for (const Tet& small : small_tetrahedra()) {
    const AtBounds at = at_bounds(small, bounds, counts);
    if ((!at.min_angle && !at.max_angle && !at.ratio) || is_bad(small, bounds, counts)) continue;
    seen.min_angle += at.min_angle, seen.max_angle += at.max_angle, seen.ratio += at.ratio;
    for (double factor : {53.0, 101.0, 131.0, 1000003.0, 0x1p44 - 1}) {
      Tet t = scaled(small, factor);
      ASSERT_FALSE(is_bad(t, bounds, counts));
      for (int n = 0; n < 24; ++n) {
        Tet moved = t;
        moved[static_cast<std::size_t>(n / 6)][n / 2 % 3] += n % 2 ? 1 : -1;
        const bool bad = is_bad(moved, bounds, counts);
        if (n % 5 == 0) {
          ASSERT_EQ(bad, reference_is_bad(moved, bounds));
        }
        if (bad) beyond.min_angle += at.min_angle, beyond.max_angle += at.max_angle, beyond.ratio += at.ratio;
      }
    }
  }
  EXPECT_GT(seen.min_angle, 0);
  EXPECT_GT(seen.max_angle, 0);
  EXPECT_GT(seen.ratio, 0);
  EXPECT_GT(beyond.min_angle, 0);
  EXPECT_GT(beyond.max_angle, 0);
  EXPECT_GT(beyond.ratio, 0);
}

/// The corner of a cube has a ratio^2 of 3/4 and angles of 90 and acos(1/sqrt(3)) degrees.
TEST(QualitySigns, EveryStageIsReached) {
  const auto corner = [](double side) {
    return Tet{Vec3{0, 0, 0}, Vec3{side, 0, 0}, Vec3{0, side, 0}, Vec3{0, 0, side}};
  };
  StageCounts counts;
  EXPECT_EQ(compare_radius_edge(corner(1000), {5, 4}, counts), -1);
  EXPECT_EQ(counts.filter, 1U);
  EXPECT_EQ(compare_radius_edge(corner(3), {3, 4}, counts), 0);
  EXPECT_EQ(compare_radius_edge(corner(0x1p40), {3, 4}, counts), 0);
  EXPECT_EQ(compare_radius_edge(corner(4095), {3, 4}, counts), 0);
  EXPECT_EQ(compare_dihedral(corner(4095), 0, 1, {1, 1, 3}, counts), 0);
  EXPECT_EQ(counts.small, 4U);
  EXPECT_EQ(compare_radius_edge(corner(0x1p40 - 1), {3, 4}, counts), 0);
  EXPECT_EQ(compare_dihedral(corner(0x1p40 - 1), 1, 2, {0, 0, 1}, counts), 0);
  EXPECT_EQ(counts.wide, 2U);
  const QualityBounds tight{{1, 1, 3}, {0, 0, 1}, {3, 4}};
  EXPECT_FALSE(is_bad(corner(0x1p40 - 1), tight, counts));
  EXPECT_TRUE(is_bad(corner(0x1p40 - 1), {{1, 1, 3}, {0, 0, 1}, {1048573, 1398100}}, counts));
  EXPECT_EQ(counts.filter + counts.small + counts.wide, 9U);
}

TEST(QualitySigns, RotatingTheCornersAndTranslatingChangesNothing) {
  SCOPED_TRACE("seed 4");
  Generator random(4);
  StageCounts counts;
  const QualityBounds bounds{{1, 1, 2}, {-1, 1, 4}, {3, 4}};
  for (int n = 0; n < 5000; ++n) {
    Tet t = random.lattice<4>(3, 16, n % 2);
    if (n % 3 == 0) random.nudge(t);
    if (is_flat(t, counts)) continue;
    t = positive(t, counts);
    const Vec3 offset = random.vector(40);
    const Tet rotated = {t[1] + offset, t[2] + offset, t[0] + offset, t[3] + offset};
    ASSERT_EQ(is_bad(rotated, bounds, counts), is_bad(t, bounds, counts));
    ASSERT_EQ(compare_dihedral(t, 0, 3, bounds.min_dihedral, counts),
              compare_dihedral(rotated, 3, 2, bounds.min_dihedral, counts));
  }
}

}  // namespace
}  // namespace unsliver::exact
