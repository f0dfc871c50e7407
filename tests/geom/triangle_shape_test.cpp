#include "geom/triangle_shape.hpp"

#include <gtest/gtest.h>

#include "domain/sample_surfaces.hpp"

namespace unsliver::geom {
namespace {

using samples::Dice;

Triangle random_triangle(Dice& dice, double size) {
  return {dice.around({}, size), dice.around({}, size), dice.around({}, size)};
}

Vec3 sample(Dice& dice, const Triangle& t) {
  const double a = dice.unit(), b = dice.unit() * (1 - a);
  return t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
}

TEST(TriangleShape, ClosestPointIsNoFartherThanAnySample) {
  Dice dice(1);
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    Triangle t = random_triangle(dice, 1);
    if (n % 5 == 1) t[2] = 0.5 * (t[0] + t[1]);          // collinear
    if (n % 5 == 2) t[2] = t[0] + 1e-9 * (t[2] - t[0]);  // needle
    if (n % 5 == 3) t[2] = t[1] = t[0];                  // point
    const Vec3 p = dice.around({}, n % 2 ? 2.0 : 0.5);
    const Vec3 q = closest_point(t, p);
    const double distance = dist(p, q), allowed = closest_point_slack(t) * (4 + distance);
    for (int i = 0; i < 300; ++i) EXPECT_LE(distance, dist(p, sample(dice, t)) + allowed);
    for (const Vec3& corner : t) EXPECT_LE(distance, dist(p, corner) + allowed);
  }
}

TEST(TriangleShape, ClosestPointIsOnTheTriangle) {
  Dice dice(2);
  for (int n = 0; n < 1000; ++n) {
    const Triangle t = random_triangle(dice, 1);
    const Vec3 q = closest_point(t, dice.around({}, 3));
    EXPECT_LT(dist(q, closest_point(t, q)), 1e-13);
    EXPECT_TRUE(is_finite(q));
  }
}

TEST(TriangleShape, SolidAnglesOfATetrahedronAddUp) {
  Dice dice(3);
  for (int n = 0; n < 500; ++n) {
    const Tet t = dice.tet_around({}, 1);
    const auto sum = [&](const Vec3& p) {
      return winding_of({t[1], t[2], t[3]}, p) + winding_of({t[0], t[3], t[2]}, p) +
             winding_of({t[0], t[1], t[3]}, p) + winding_of({t[0], t[2], t[1]}, p);
    };
    EXPECT_NEAR(sum(dice.inside(t)), 1, 1e-6);
    EXPECT_NEAR(sum({5, 5, 5}), 0, 1e-6);
  }
}

TEST(TriangleShape, TouchingIsNotMeetingTheInterior) {
  const Tet t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const TetProbe open(t, TetProbe::Extent::kInterior), closed(t, TetProbe::Extent::kClosed);
  const auto expect_touch = [&](const Triangle& s) {
    EXPECT_FALSE(open.may_meet(s));
    EXPECT_TRUE(closed.may_meet(s));
  };
  expect_touch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});          // a face itself
  expect_touch({{{0.1, 0.1, 0}, {2, 0, 0}, {0, 2, 0}}});      // coplanar overlap
  expect_touch({{{0.25, 0.25, 0.5}, {1, 1, 1}, {1, 2, 1}}});  // a corner on the slanted face
  expect_touch({{{-1, -1, 0}, {1, 1, 0}, {0, 0, -1}}});       // an edge in a face
  expect_touch({{{0, 0, 1}, {0, 0, 2}, {0, 1, 2}}});          // corner to corner
  expect_touch({{{-1, 0, -1}, {-1, 0, 1}, {0.5, 0, 0.25}}});  // in the plane y = 0
  EXPECT_TRUE(open.may_meet(Triangle{{{-1, -1, 0.2}, {2, -1, 0.2}, {0, 3, 0.2}}}));
  EXPECT_TRUE(open.may_meet(Triangle{{{0.2, 0.2, 0.2}, {5, 5, 5}, {5, 6, 5}}}));
  EXPECT_FALSE(closed.may_meet(Triangle{{{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}}));
  EXPECT_FALSE(closed.may_meet(Triangle{{{0, 0, -1e-15}, {1, 0, -1e-15}, {0, 1, -1e-15}}}));
}

/// Against samples of the triangle: one inside the tetrahedron obliges may_meet. And may_meet is not always
/// true.
TEST(TriangleShape, TetProbeNeverMissesASample) {
  for (const Vec3& offset : {Vec3{}, Vec3{1e6, -3e7, 2e5}}) {
    Dice dice(4);
    int refused = 0;
    for (int n = 0; n < 1500; ++n) {
      SCOPED_TRACE(n);
      const Tet t = dice.tet_around(offset, 1);
      Triangle s = random_triangle(dice, 1);
      for (Vec3& p : s) p = p + offset;
      const TetProbe probe(t, TetProbe::Extent::kInterior);
      const bool met = probe.may_meet(s);
      refused += !met;
      if (met) {
        EXPECT_TRUE(probe.may_meet(bounding_box(s)));
        EXPECT_TRUE(TetProbe(t, TetProbe::Extent::kClosed).may_meet(s));
        continue;
      }
      for (int i = 0; i < 200; ++i) {
        const Vec3 p = sample(dice, s);
        bool inside = true;
        for (std::size_t k = 0; k < 4; ++k) {
          Tet moved = t;
          moved[k] = p;
          inside = inside && dot(moved[1] - moved[0], cross(moved[2] - moved[0], moved[3] - moved[0])) > 1e-7;
        }
        EXPECT_FALSE(inside);
      }
    }
    EXPECT_GT(refused, 300);
  }
}

TEST(TriangleShape, WindingGain) {
  const Triangle t{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  EXPECT_EQ(winding_gain(t, {0.5, 0.6, 1}, {0.5, 0.6, -1}), 1);
  EXPECT_EQ(winding_gain(t, {0.5, 0.6, -1}, {0.5, 0.6, 1}), -1);
  EXPECT_EQ(winding_gain(t, {0.5, 0.6, 2}, {0.5, 0.6, 1}), 0);
  EXPECT_EQ(winding_gain(t, {2, 2, 2}, {2, 2, -1}), 0);
  EXPECT_EQ(winding_gain(t, {1, 0, 1}, {1, 0, -1}), std::nullopt);      // through an edge
  EXPECT_EQ(winding_gain(t, {0.5, 0.5, 0}, {1, 1, -1}), std::nullopt);  // from the triangle
}

TEST(TriangleShape, CrossingPairs) {
  const Triangle t{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  EXPECT_TRUE(triangles_cross(t, {{{0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 1}}}, 0));
  EXPECT_TRUE(triangles_cross(t, {{{0.5, 0.5, 0}, {3, 3, 0}, {3, 4, 0}}}, 0));          // coplanar overlap
  EXPECT_TRUE(triangles_cross(t, {{{0.1, 0.1, 0}, {0.2, 0.1, 0}, {0.1, 0.2, 0}}}, 0));  // one holds the other
  EXPECT_FALSE(triangles_cross(t, {{{3, 3, 0}, {4, 3, 0}, {3, 4, 0}}}, 0));
  EXPECT_FALSE(triangles_cross(t, {{{0.5, 0.5, 1}, {1, 1, 1}, {3, 3, 2}}}, 0));
  // One common corner.
  EXPECT_FALSE(triangles_cross(t, {{{0, 0, 0}, {-1, 0, 1}, {-1, 0, -1}}}, 1));
  EXPECT_TRUE(triangles_cross(t, {{{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}}, 1));
  EXPECT_FALSE(triangles_cross(t, {{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}, 1));   // coplanar, opposite corners
  EXPECT_TRUE(triangles_cross(t, {{{0, 0, 0}, {1, 0.5, 0}, {0.5, 1, 0}}}, 1));  // coplanar, on top
  // A common edge.
  EXPECT_FALSE(triangles_cross(t, {{{0, 0, 0}, {2, 0, 0}, {0, 0, 2}}}, 2));
  EXPECT_FALSE(triangles_cross(t, {{{0, 0, 0}, {2, 0, 0}, {0, -2, 0}}}, 2));
  EXPECT_TRUE(triangles_cross(t, {{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}}, 2));  // folded back
}

}  // namespace
}  // namespace unsliver::geom
