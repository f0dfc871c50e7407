#include "geom/triangle_tree.hpp"

#include <gtest/gtest.h>

#include "domain/sample_surfaces.hpp"
#include "geom/triangle_shape.hpp"

namespace unsliver::geom {
namespace {

using samples::Dice;

Triangle triangle(const TriangleMesh& m, std::size_t t) {
  const auto& v = m.triangles[t];
  return {m.points[v[0]], m.points[v[1]], m.points[v[2]]};
}

TriangleMesh soup(Dice& dice, int count, double size) {
  TriangleMesh m;
  for (int i = 0; i < count; ++i) {
    const Vec3 at = dice.around({}, 1);
    const auto first = static_cast<VertexId>(m.points.size());
    for (int k = 0; k < 3; ++k) m.points.push_back(dice.around(at, size));
    m.triangles.push_back({first, first + 1, first + 2});
  }
  return m;
}

double plain_distance(const TriangleMesh& m, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    least = std::min(least, dist(p, closest_point(triangle(m, t), p)));
  return least;
}

double plain_winding(const TriangleMesh& m, const Vec3& p) {
  double sum = 0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) sum += winding_of(triangle(m, t), p);
  return sum;
}

class TriangleTreeOnSurfaces : public testing::TestWithParam<int> {
 protected:
  TriangleMesh surface() {
    switch (GetParam()) {
      case 0:
        return samples::sphere_surface({0.1, 0.2, 0.3}, 1, 12);
      case 1:
        return soup(dice_, 600, 0.2);
      case 2:
        return samples::box_surface({{-1, -1, -1}, {1, 1, 1}});
      default:
        return soup(dice_, 1, 1);
    }
  }
  Dice dice_{11};
};

TEST_P(TriangleTreeOnSurfaces, NearestIsTheLeastOfAll) {
  const TriangleMesh m = surface();
  const TriangleTree tree(m);
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    const Vec3 p = dice_.around({}, n % 3 ? 1.5 : 20);
    const double expected = plain_distance(m, p);
    const auto found = tree.nearest(p, std::numeric_limits<double>::infinity());
    EXPECT_EQ(found.distance, expected);
    EXPECT_NEAR(dist(p, found.point), expected, 1e-15 * (1 + expected));
    EXPECT_NEAR(dist(found.point, closest_point(triangle(m, found.triangle), found.point)), 0, 1e-12);
    EXPECT_EQ(tree.nearest(p, 0.9 * expected).distance, std::numeric_limits<double>::infinity());
    EXPECT_EQ(tree.nearest(p, 1.1 * expected).distance, expected);
    EXPECT_LE(tree.clear_radius(p), expected);
    EXPECT_GE(tree.clear_radius(p), 0.7 * expected - 1e-6);
  }
}

TEST_P(TriangleTreeOnSurfaces, WindingNumberIsThePlainSum) {
  const TriangleMesh m = surface();
  const TriangleTree tree(m);
  for (int n = 0; n < 300; ++n) {
    const Vec3 p =
        n % 2 ? dice_.around({}, 2) : dice_.around(dice_.on(m, dice_.below(m.triangles.size())), 0.1);
    EXPECT_NEAR(tree.winding_number(p), plain_winding(m, p), 1e-3) << n;
  }
}

TEST_P(TriangleTreeOnSurfaces, BoxDistanceIsALowerBound) {
  const TriangleMesh m = surface();
  const TriangleTree tree(m);
  for (int n = 0; n < 100; ++n) {
    const Vec3 a = dice_.around({}, 2);
    Box3 box{a, a};
    box.extend(dice_.around(a, 0.2));
    const double bound = tree.distance_lower_bound(box);
    EXPECT_GE(bound, 0);
    for (int i = 0; i < 10; ++i) EXPECT_LE(bound, plain_distance(m, dice_.in(box)));
    EXPECT_NEAR(tree.distance_lower_bound({a, a}), plain_distance(m, a), 1e-6);
  }
}

TEST_P(TriangleTreeOnSurfaces, MeetsExactlyTheTetrahedraThatATriangleMeets) {
  const TriangleMesh m = surface();
  const TriangleTree tree(m);
  int met = 0;
  for (int n = 0; n < 400; ++n) {
    const Tet t = dice_.tet_around(dice_.around({}, 1), 0.15);
    const TetProbe open(t, TetProbe::Extent::kInterior), closed(t, TetProbe::Extent::kClosed);
    bool some_open = false, some_closed = false;
    for (std::size_t i = 0; i < m.triangles.size(); ++i) {
      some_open = some_open || open.may_meet(triangle(m, i));
      some_closed = some_closed || closed.may_meet(triangle(m, i));
    }
    EXPECT_EQ(tree.may_meet_interior(t), some_open) << n;
    EXPECT_EQ(tree.may_meet(t), some_closed) << n;
    met += some_open;
  }
  EXPECT_GT(met, 0);
  EXPECT_LT(met, 400);
}

TEST(TriangleTree, WindingGainIsTheDifferenceOnClosedSurfaces) {
  const TriangleMesh m =
      samples::joined(samples::sphere_surface({}, 1, 9), samples::sphere_surface({0.5, 0, 0}, 1, 7));
  const TriangleTree tree(m);
  Dice dice(6);
  int changes = 0;
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = dice.around({}, 1.5), q = dice.around(p, 0.5);
    const auto gain = tree.winding_gain(p, q);
    ASSERT_TRUE(gain.has_value());
    EXPECT_EQ(*gain, std::lround(tree.winding_number(q)) - std::lround(tree.winding_number(p)));
    changes += *gain != 0;
  }
  EXPECT_GT(changes, 200);
}

INSTANTIATE_TEST_SUITE_P(All, TriangleTreeOnSurfaces, testing::Range(0, 4));

TEST(TriangleTree, WithoutTriangles) {
  const TriangleTree tree(TriangleMesh{});
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(tree.nearest({}, infinity).distance, infinity);
  EXPECT_EQ(tree.clear_radius({}), infinity);
  EXPECT_EQ(tree.winding_number({}), 0);
  EXPECT_FALSE(tree.may_meet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
}

TEST(TriangleTree, LargeSphereStaysWithinTheWindingError) {
  const TriangleMesh m = samples::sphere_surface({}, 1, 60);
  const TriangleTree tree(m);
  Dice dice(5);
  double worst = 0;
  for (int n = 0; n < 60; ++n) {
    const Vec3 p = dice.around(dice.on(m, dice.below(m.triangles.size())), 0.05);
    worst = std::max(worst, std::abs(tree.winding_number(p) - plain_winding(m, p)));
  }
  EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace unsliver::geom
