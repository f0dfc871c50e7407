/// The perturbation defines one Delaunay tetrahedralization of cospherical points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "exact/predicates.hpp"
#include "generators.hpp"

namespace unsliver::exact {
namespace {

using Corners = std::array<std::size_t, 4>;

std::vector<Vec3> cube(double side, const Vec3& corner) {
  std::vector<Vec3> points;
  for (unsigned m = 0; m < 8; ++m)
    points.push_back(corner + side * Vec3{double(m & 1), double(m >> 1 & 1), double(m >> 2 & 1)});
  return points;
}

/// The midpoints of the edges of a cube: 12 points on a sphere, squares and triangles as hull.
std::vector<Vec3> cuboctahedron(double side) {
  std::vector<Vec3> points;
  for (double s : {-side, side})
    for (double t : {-side, side}) points.insert(points.end(), {{s, t, 0}, {s, 0, t}, {0, s, t}});
  return points;
}

/// All positively oriented quadruples that no other point is in conflict with.
std::vector<Corners> delaunay(const std::vector<Vec3>& p, StageCounts& counts) {
  std::vector<Corners> result;
  const std::size_t n = p.size();
  const auto is_empty = [&](const Corners& t) {
    for (std::size_t e = 0; e < n; ++e) {
      if (std::find(t.begin(), t.end(), e) != t.end()) continue;
      if (insphere_perturbed(p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[e], counts) > 0) return false;
    }
    return true;
  };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c)
        for (std::size_t d = c + 1; d < n; ++d) {
          Corners t = {a, b, c, d};
          const int sign = orient3d(p[a], p[b], p[c], p[d], counts);
          if (sign < 0) std::swap(t[0], t[1]);
          if (sign != 0 && is_empty(t)) result.push_back(t);
        }
  return result;
}

double six_volumes(const std::vector<Vec3>& p, const std::vector<Corners>& tets) {
  double sum = 0;
  for (const Corners& t : tets) sum += dot(p[t[1]] - p[t[0]], cross(p[t[2]] - p[t[0]], p[t[3]] - p[t[0]]));
  return sum;
}

/// The triangles that belong to one tetrahedron; fails where more than two meet.
std::size_t boundary_triangles(const std::vector<Corners>& tets) {
  std::multiset<std::array<std::size_t, 3>> triangles;
  for (const Corners& t : tets)
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<std::size_t, 3> f{};
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != skip) f[n++] = t[i];
      std::sort(f.begin(), f.end());
      triangles.insert(f);
    }
  std::size_t boundary = 0;
  for (const auto& f : triangles) {
    EXPECT_LE(triangles.count(f), 2U);
    if (triangles.count(f) == 1) ++boundary;
  }
  return boundary;
}

std::set<std::set<std::array<double, 3>>> as_coordinates(const std::vector<Vec3>& p,
                                                         const std::vector<Corners>& tets) {
  std::set<std::set<std::array<double, 3>>> result;
  for (const Corners& t : tets) {
    std::set<std::array<double, 3>> corners;
    for (std::size_t v : t) corners.insert({p[v].x, p[v].y, p[v].z});
    result.insert(corners);
  }
  return result;
}

void expect_one_tiling(std::vector<Vec3> points, double volume, std::size_t boundary) {
  StageCounts counts;
  const auto tets = delaunay(points, counts);
  EXPECT_EQ(six_volumes(points, tets), 6 * volume);
  EXPECT_EQ(boundary_triangles(tets), boundary);
  EXPECT_GT(counts.tie, 0U);
  const auto expected = as_coordinates(points, tets);
  SCOPED_TRACE("seed 1");
  Generator random(1);
  for (int n = 0; n < 5; ++n) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
    EXPECT_TRUE(as_coordinates(points, delaunay(points, counts)) == expected);
  }
}

TEST(Perturbation, TilesACubeInOneWay) {
  expect_one_tiling(cube(4, {0, 0, 0}), 64, 12);
  expect_one_tiling(cube(0x1p15 - 1, {-7, 5, 3}), 35181150961663.0, 12);
}

TEST(Perturbation, TilesACuboctahedronInOneWay) {
  expect_one_tiling(cuboctahedron(3), 20.0 / 3 * 27, 20);
  expect_one_tiling(cuboctahedron(0x1p12), 20.0 / 3 * 0x1p36, 20);
}

/// Neighbouring cubes must split their common face alike: two cubes tile as one block does.
TEST(Perturbation, NeighbouringCubesAgreeOnTheirFace) {
  std::vector<Vec3> block = cube(2, {0, 0, 0});
  for (double y : {0.0, 2.0})
    for (double z : {0.0, 2.0}) block.push_back({4, y, z});
  expect_one_tiling(block, 16, 20);
}

/// Whichever point is largest, and however large all are, the rule decides.
TEST(Perturbation, DecidesInWideIntegersToo) {
  SCOPED_TRACE("seed 2");
  Generator random(2);
  StageCounts counts;
  for (int n = 0; n < 2000; ++n) {
    auto p = random.cospherical<5>(47);
    const int orient = orient3d(p[0], p[1], p[2], p[3], counts);
    if (orient == 0 || !last_is_distinct(p)) continue;
    if (orient < 0) std::swap(p[0], p[1]);
    ASSERT_NE(insphere_perturbed(p[0], p[1], p[2], p[3], p[4], counts), 0);
  }
  EXPECT_GT(counts.wide, 0U);
  EXPECT_GT(counts.tie, 0U);
}

}  // namespace
}  // namespace unsliver::exact
