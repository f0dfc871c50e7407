// Convex hulls: convex by exact integers, of the volume that every triple of points on one side gives, and
// good to mesh with the points as vertices.
#include "unsliver/hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/verify.hpp"

namespace unsliver {
namespace {

using Points = std::vector<Vec3>;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double lo, double hi) { return lo + unit() * (hi - lo); }
  Vec3 in_box(const Vec3& lo, const Vec3& hi) {
    const double x = between(lo.x, hi.x), y = between(lo.y, hi.y), z = between(lo.z, hi.z);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

Points random_points(std::size_t count, std::uint64_t seed, const Vec3& size = {1, 1, 1}) {
  Random random(seed);
  Points points(count);
  for (Vec3& p : points) p = random.in_box({0, 0, 0}, size);
  return points;
}

/// So few bits that 64-bit integers decide everything: multiples of 1/64 below 2^9.
Points short_points(std::size_t count, std::uint64_t seed, double steps) {
  Points points = random_points(count, seed, {steps, steps, steps});
  for (Vec3& p : points) p = 0x1p-6 * Vec3{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  return points;
}

Points on_sphere(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Points points;
  while (points.size() < count) {
    const Vec3 p = random.in_box({-1, -1, -1}, {1, 1, 1});
    if (norm(p) > 0.1 && norm(p) < 1) points.push_back(1 / norm(p) * p);
  }
  return points;
}

/// n^3 points, `step` apart.
Points cube_grid(int n, double step) {
  Points points;
  for (int i = 0; i < n * n * n; ++i)
    points.push_back({step * (i % n), step * (i / n % n), step * (i / (n * n))});
  return points;
}

Points rotated(Points points) {
  for (Vec3& p : points) p = {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z + 0.3 * p.x};
  return points;
}

Points moved(Points points, const Vec3& by) {
  for (Vec3& p : points) p = p + by;
  return points;
}

Points stretched(Points points, double factor) {
  for (Vec3& p : points) p = factor * p;
  return points;
}

double det(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(b - a, c - a), d - a);
}

/// Six times the volume beyond the plane of a, b and c, as an exact number of (1/64)^3. Requires short
/// points.
std::int64_t exact_det(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto step = [&a](const Vec3& p, int axis) {
    return static_cast<std::int64_t>(64 * p[axis]) - static_cast<std::int64_t>(64 * a[axis]);
  };
  const auto minor = [&](int i, int j) { return step(b, i) * step(c, j) - step(b, j) * step(c, i); };
  return minor(1, 2) * step(d, 0) + minor(2, 0) * step(d, 1) + minor(0, 1) * step(d, 2);
}

double volume_of(const TriangleMesh& hull) { return inspect_surface(hull).signed_volume; }

double extent_of(const Points& points) {
  Box3 box;
  for (const Vec3& p : points) box.extend(p);
  return box.longest_side();
}

void expect_closed_and_clean(const TriangleMesh& hull) {
  const SurfaceDefects defects = inspect_surface(hull);
  EXPECT_TRUE(defects.clean());
  EXPECT_EQ(defects.components, 1u);
  EXPECT_EQ(defects.degenerate_triangles.count, 0u);
  EXPECT_GT(defects.signed_volume, 0);
  EXPECT_EQ(hull.triangles.size() + 4, 2 * hull.points.size());  // Euler's, of a sphere
}

void expect_within(const TriangleMesh& hull, const Points& points, double tolerance) {
  for (const auto& [a, b, c] : hull.triangles) {
    const Vec3 &p = hull.points[a], &q = hull.points[b], &r = hull.points[c];
    const Vec3 normal = cross(q - p, r - p);
    for (const Vec3& x : points) ASSERT_LE(dot(normal, x - p), tolerance * norm(normal));
  }
}

/// Some oriented triple has all other points strictly on its inner side exactly where it is a facet, given
/// that no four points lie in a plane.
double volume_by_triples(const Points& points) {
  double sum = 0;
  const auto is_facet = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec3& p) { return p == a || p == b || p == c || det(a, b, c, p) < 0; });
  };
  for (const Vec3& a : points)
    for (const Vec3& b : points)
      for (const Vec3& c : points)
        if (lex_less(a, b) && lex_less(a, c) && !(b == c) && is_facet(a, b, c))
          sum += dot(a, cross(b, c)) / 6;
  return sum;
}

TEST(Hull, IsConvexByExactIntegers) {
  for (const double steps : {3.0, 8.0, 32768.0})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", steps " << steps);
      const Points points = short_points(60, seed, steps);
      const TriangleMesh hull = convex_hull(points);
      expect_closed_and_clean(hull);
      for (const auto& [a, b, c] : hull.triangles)
        for (const Vec3& p : points)
          ASSERT_LE(exact_det(hull.points[a], hull.points[b], hull.points[c], p), 0);
      for (const Vec3& corner : hull.points)  // short points are on the grid
        EXPECT_NE(std::find(points.begin(), points.end(), corner), points.end());
    }
}

TEST(Hull, HasTheVolumeThatTriplesGive) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Points points = random_points(5 + seed, seed);
    EXPECT_NEAR(volume_of(convex_hull(points)), volume_by_triples(points), 1e-12);
  }
}

TEST(Hull, OfATetrahedron) {
  const TriangleMesh hull = convex_hull(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}});
  EXPECT_EQ(hull.triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(volume_of(hull), 1.0 / 6);
  EXPECT_EQ(hull.name, "convex hull of 5 points");
}

TEST(Hull, OfASphereHasAllPoints) {
  const Points points = on_sphere(2000, 1);
  const TriangleMesh hull = convex_hull(points);
  expect_closed_and_clean(hull);
  EXPECT_EQ(hull.points.size(), points.size());
  expect_within(hull, points, 1e-13);  // rounded
  const double ball = 4 * std::acos(-1.0) / 3;
  EXPECT_LT(volume_of(hull), ball);
  EXPECT_GT(volume_of(hull), 0.99 * ball);
}

TEST(Hull, OfACubeHasThePointsAmidItsFacesAndEdges) {
  const TriangleMesh hull = convex_hull(cube_grid(6, 0.25));
  expect_closed_and_clean(hull);
  EXPECT_EQ(hull.points.size(), 6u * 6 * 6 - 4 * 4 * 4);
  EXPECT_NEAR(volume_of(hull), std::pow(1.25, 3), 1e-14);
}

TEST(Hull, OfPointsOffTheGridIsWithinRounding) {
  const Points cube = cube_grid(5, 0.1);
  const std::vector<Points> cases = {cube,
                                     rotated(cube),
                                     rotated(on_sphere(200, 2)),
                                     moved(random_points(200, 3), {1e6, -0x1p17, 1e3}),
                                     stretched(rotated(cube), 1e50),
                                     stretched(rotated(cube), 1e-50),
                                     random_points(200, 4, {1, 1, 1e-9}),
                                     random_points(200, 5, {1, 1e-8, 1e-8}),
                                     rotated(random_points(200, 6, {1e-9, 1, 1}))};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    const TriangleMesh hull = convex_hull(cases[i]);
    expect_closed_and_clean(hull);
    const double step = 0x1p-46 * extent_of(cases[i]);
    for (const Vec3& corner : hull.points)
      EXPECT_TRUE(std::any_of(cases[i].begin(), cases[i].end(), [&](const Vec3& p) {
        return std::abs(p.x - corner.x) <= 0.5 * step && std::abs(p.y - corner.y) <= 0.5 * step &&
               std::abs(p.z - corner.z) <= 0.5 * step;
      }));
  }
  EXPECT_NEAR(volume_of(convex_hull(rotated(cube))), std::pow(0.4, 3), 1e-13);
}

TEST(Hull, IsTheSameSurfaceInEveryOrder) {
  Points points = random_points(100, 7);
  const double volume = volume_of(convex_hull(points));
  const std::size_t facets = convex_hull(points).triangles.size();
  std::reverse(points.begin(), points.end());
  points.insert(points.end(), points.begin(), points.begin() + 50);
  EXPECT_NEAR(volume_of(convex_hull(points)), volume, 1e-14);
  EXPECT_EQ(convex_hull(points).triangles.size(), facets);
}

std::string refusal(const Points& points, ErrorCode code) {
  try {
    convex_hull(points);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(Hull, RefusesWhatHasNoVolume) {
  const auto says = [](const Points& points, const char* words) {
    const std::string message = refusal(points, ErrorCode::kUnsupported);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  says({{1, 2, 3}}, "a single point");
  says(Points(7, Vec3{1, 2, 3}), "the 7 points lie at one place");
  says({{0, 0, 0}, {1, 1, 1}}, "lie on a line");
  says({{0, 0, 0}, {1, 1, 1}, {0, 1, 0}}, "lie in a plane");
  says(rotated(random_points(50, 1, {1, 0, 0})), "lie on a line");
  says(rotated(random_points(50, 2, {1, 0, 1})), "lie in a plane");
  says(rotated(random_points(50, 3, {1, 1e-12, 1})), "lie in a plane");
  says(moved(rotated(random_points(50, 4, {1e-12, 1e-12, 1})), {3, 4, 5}), "lie on a line");
}

TEST(Hull, RefusesBadInput) {
  EXPECT_NE(refusal({}, ErrorCode::kBadInput), "");
  Points points = random_points(5, 1);
  points[3].y = std::nan("");
  EXPECT_NE(refusal(points, ErrorCode::kBadInput).find("point 3"), std::string::npos);
  points[3].y = 1e300;
  refusal(points, ErrorCode::kBadInput);
}

/// The points themselves, and points between them.
Points hull_samples(const Points& points, std::uint64_t seed) {
  Points samples = points;
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    Vec3 p = points[static_cast<std::size_t>(random.unit() * points.size())];
    for (int step = 0; step < 3; ++step) {
      const Vec3& q = points[static_cast<std::size_t>(random.unit() * points.size())];
      p = p + random.unit() * (q - p);
    }
    samples.push_back(p);
  }
  return samples;
}

void expect_inputs_first(const Points& inputs, const TetMesh& mesh) {
  ASSERT_GE(mesh.points.size(), inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) EXPECT_EQ(mesh.points[i], inputs[i]);
}

TEST(Hull, IsMeshedWithItsPoints) {
  const std::vector<Points> cases = {random_points(40, 1),
                                     on_sphere(60, 2),
                                     cube_grid(4, 0.25),
                                     cube_grid(4, 0.1),
                                     rotated(cube_grid(4, 0.1)),
                                     moved(random_points(20, 3), {1e5, 2e5, -3e5}),
                                     random_points(20, 4, {1, 1, 1e-9}),
                                     rotated(random_points(20, 5, {1, 1e-8, 1e-8})),
                                     random_points(4, 6)};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    const Points& inputs = cases[i];
    const TriangleMesh hull = convex_hull(inputs);
    const DomainPtr domain = make_surface(hull);
    EXPECT_TRUE(domain->notes().empty());
    const MeshResult result = mesh_domain(*domain, *constant_size(1e30), inputs);
    EXPECT_TRUE(result.notes.empty()) << result.notes.front();
    expect_inputs_first(inputs, result.mesh);
    VerifyOptions asked;
    asked.guarantee = {30, 135, 1.368};
    asked.must_cover = hull_samples(inputs, i);
    asked.must_cover.insert(asked.must_cover.end(), hull.points.begin(), hull.points.end());
    asked.cover_tolerance = 4e-15 * (1 + (i == 5 ? 1e6 : 0));
    const VerifyReport report = verify(result.mesh, asked);
    EXPECT_TRUE(report.ok) << report.findings.front().message;
    EXPECT_GE(report.volume, volume_of(hull) * (1 - 1e-9));
  }
}

}  // namespace
}  // namespace unsliver
