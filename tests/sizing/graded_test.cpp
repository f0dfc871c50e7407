#include <limits>

#include "sizing_properties.hpp"

namespace unsliver {
namespace {

using namespace test;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::numeric_limits<double>::quiet_NaN();
const Box3 kCube{{-1, -1, -1}, {1, 1, 1}};
const Box3 kWider{{-2, -2, -2}, {2, 2, 2}};

TEST(GradedFromPoints, IsTheMinimumByBruteForce) {
  for (std::size_t count : {1u, 2u, 5u, 300u}) {
    Random random(count);
    std::vector<Vec3> points;
    std::vector<double> h0;
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back(random.in(kCube));
      h0.push_back(random.uniform(0.01, 0.4));
    }
    const SizingPtr s = graded_from_points(points, h0, 0.3, 0.7);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = random.in(kWider);
      double expected = 0.7;
      for (std::size_t k = 0; k < count; ++k) expected = std::min(expected, h0[k] + 0.3 * dist(p, points[k]));
      EXPECT_DOUBLE_EQ(s->at(p), expected);
    }
    expect_sound(*s, kWider, 500);
    expect_tight(*s, kWider, 0.3);
    EXPECT_EQ(s->lipschitz(), 0.3);
  }
}

TEST(GradedFromPoints, OneSizeServesAllPointsAndTheCapMayBeInfinite) {
  const SizingPtr s = graded_from_points({{0, 0, 0}, {10, 0, 0}}, {0.5}, 0.1, kInf);
  EXPECT_DOUBLE_EQ(s->at({4, 0, 0}), 0.9);
  EXPECT_DOUBLE_EQ(s->at({9, 0, 0}), 0.6);
  EXPECT_DOUBLE_EQ(s->lower_bound({{2, -1, 0}, {4, 3, 0}}), 0.7);
  EXPECT_DOUBLE_EQ(s->at({1e6, 0, 0}), 0.5 + 0.1 * (1e6 - 10));
}

TEST(GradedFromPoints, CountsThePoints) {
  EXPECT_EQ(graded_from_points({{0, 0, 0}}, {1}, 0.5, 2)->describe(),
            "graded from 1 point, gradation 0.5, at most 2");
  EXPECT_EQ(graded_from_points({{0, 0, 0}, {1, 0, 0}}, {1}, 0.5, 2)->describe(),
            "graded from 2 points, gradation 0.5, at most 2");
}

TEST(GradedFromPoints, NamesTheBadPoint) {
  using Points = std::vector<Vec3>;
  const Points two{{0, 0, 0}, {1, 2, 3}};
  expect_error([] { graded_from_points({}, {1}, 1, 1); }, ErrorCode::kBadInput, "No points");
  expect_error(
      [&] {
        graded_from_points(two, {1, 2, 3}, 1, 1);
      },
      ErrorCode::kBadInput, "3 sizes were given for 2");
  expect_error([&] { graded_from_points(two, {}, 1, 1); }, ErrorCode::kBadInput, "0 sizes");
  expect_error([&] { graded_from_points(two, {1}, -1, 1); }, ErrorCode::kBadOption, "gradation is -1");
  expect_error([&] { graded_from_points(two, {1}, kNan, 1); }, ErrorCode::kBadOption, "gradation is nan");
  expect_error([&] { graded_from_points(two, {1}, 1, 0); }, ErrorCode::kBadOption, "largest size is 0");
  expect_error(
      [&] {
        graded_from_points({{kNan, 0, 0}}, {1}, 1, 1);
      },
      ErrorCode::kBadInput, "point 0 at (nan");
  for (double bad : {0.0, -2.0, kNan, kInf}) {
    const Error e = expect_error(
        [&] {
          graded_from_points(two, {1, bad}, 1, 1);
        },
        ErrorCode::kBadInput, "Sizing point 1 at (1, 2, 3)");
    EXPECT_EQ(e.ids, std::vector<std::int64_t>{1});
  }
}

/// The surface of [-1, 1]^3 as 12 triangles.
TriangleMesh cube_surface() {
  TriangleMesh m;
  for (int i = 0; i < 8; ++i)
    m.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  for (const auto& q : {std::array<VertexId, 4>{0, 1, 3, 2},
                        {4, 5, 7, 6},
                        {0, 1, 5, 4},
                        {2, 3, 7, 6},
                        {0, 2, 6, 4},
                        {1, 3, 7, 5}}) {
    m.triangles.push_back({q[0], q[1], q[2]});
    m.triangles.push_back({q[0], q[2], q[3]});
  }
  m.name = "cube.off";
  return m;
}

double distance_to_cube_surface(const Vec3& p) {
  const Vec3 a{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)};
  if (kCube.contains(p)) return 1 - std::max({a.x, a.y, a.z});
  return norm({std::max(a.x - 1, 0.0), std::max(a.y - 1, 0.0), std::max(a.z - 1, 0.0)});
}

TEST(GradedFromSurface, GrowsWithTheDistance) {
  for (double cap : {0.2, 0.35, kInf}) {
    const SizingPtr s = graded_from_surface(cube_surface(), 0.1, 0.25, cap);
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = random.in(kWider);
      EXPECT_NEAR(s->at(p), std::min(cap, 0.1 + 0.25 * distance_to_cube_surface(p)), 1e-14);
    }
    expect_sound(*s, kWider, 1000);
    expect_tight(*s, kWider, 0.5);
    EXPECT_EQ(s->lipschitz(), 0.25);
    EXPECT_NE(s->describe().find("0.1 at cube.off, gradation 0.25"), std::string::npos);
  }
}

TEST(GradedFromSurface, WithoutGradationIsConstant) {
  const SizingPtr s = graded_from_surface(cube_surface(), 0.1, 0, kInf);
  EXPECT_EQ(s->at({5, 5, 5}), 0.1);
  EXPECT_EQ(s->lower_bound(kWider), 0.1);
}

TEST(GradedFromSurface, IsSoundFarFromTheOrigin) {
  TriangleMesh m = cube_surface();
  const Vec3 shift{1e6, -2e6, 3e6};
  for (Vec3& p : m.points) p = p + shift;
  expect_sound(*graded_from_surface(m, 0.1, 0.25, kInf), {kWider.lo + shift, kWider.hi + shift}, 500);
}

TEST(GradedFromSurface, RefusesBadInput) {
  const TriangleMesh m = cube_surface();
  expect_error([&] { graded_from_surface(m, 0, 1, 1); }, ErrorCode::kBadOption, "size at the surface is 0");
  expect_error([&] { graded_from_surface(m, 1, -1, 1); }, ErrorCode::kBadOption, "gradation");
  expect_error([&] { graded_from_surface(m, 1, 1, 0.5); }, ErrorCode::kBadOption,
               "below the size at the surface");
  expect_error([&] { graded_from_surface({}, 1, 1, 2); }, ErrorCode::kBadInput, "no triangles");
  TriangleMesh bad = m;
  bad.points[2].y = kNan;
  expect_error([&] { graded_from_surface(bad, 1, 1, 2); }, ErrorCode::kBadInput, "Point 2");
}

}  // namespace
}  // namespace unsliver
