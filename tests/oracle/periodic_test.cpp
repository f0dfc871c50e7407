// Periodic meshes against CGAL's periodic Delaunay triangulation of their vertices: the same tetrahedra, but
// for those with five cospherical vertices, where CGAL's choice is its own.
#include "unsliver/periodic.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <set>

namespace unsliver {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay =
    CGAL::Periodic_3_Delaunay_triangulation_3<CGAL::Periodic_3_Delaunay_triangulation_traits_3<K>>;

/// The corners, moved together so that the one whose home is least is at home, in lexicographic order.
using Named = std::array<std::array<double, 3>, 4>;

struct Corner {
  Vec3 home, place;
};

Named named(const std::array<Corner, 4>& corners) {
  const Corner& first =
      *std::min_element(corners.begin(), corners.end(),
                        [](const Corner& a, const Corner& b) { return lex_less(a.home, b.home); });
  Named result;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 p = corners[i].place - (first.place - first.home);
    result[i] = {p.x, p.y, p.z};
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::set<Named> ours(const TetMesh& mesh) {
  std::set<Named> tets;
  for (const auto& v : mesh.tets) {
    std::array<Corner, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = {mesh.points[mesh.periodicity->home[v[i]]], mesh.points[v[i]]};
    tets.insert(named(corners));
  }
  return tets;
}

std::vector<Vec3> homes(const TetMesh& mesh) {
  std::vector<Vec3> points;
  for (VertexId v = 0; v < mesh.points.size(); ++v)
    if (mesh.periodicity->home[v] == v) points.push_back(mesh.points[v]);
  return points;
}

/// In the unit cube.
std::set<Named> cgals(const std::vector<Vec3>& points) {
  std::vector<K::Point_3> input;
  for (const Vec3& p : points) input.emplace_back(p.x, p.y, p.z);
  Delaunay dt(input.begin(), input.end(), Delaunay::Iso_cuboid(0, 0, 0, 1, 1, 1));
  if (!dt.is_triangulation_in_1_sheet()) dt.convert_to_1_sheeted_covering();
  std::set<Named> tets;
  for (auto cell = dt.cells_begin(); cell != dt.cells_end(); ++cell) {
    const auto tet = dt.periodic_tetrahedron(cell);
    std::array<Corner, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const auto& [p, offset] = tet[i];
      const Vec3 home{p.x(), p.y(), p.z()};
      corners[std::size_t(i)] = {home,
                                 home + Vec3{double(offset.x()), double(offset.y()), double(offset.z())}};
    }
    tets.insert(named(corners));
  }
  return tets;
}

/// Those whose circumspheres, all smaller than half a cell, go through no fifth vertex.
std::set<Named> untied(const std::set<Named>& tets, const std::vector<Vec3>& points) {
  std::vector<Vec3> copies;
  for (const Vec3& p : points)
    for (int n = 0; n < 27; ++n) copies.push_back(p + Vec3{n % 3 - 1.0, n / 3 % 3 - 1.0, n / 9 - 1.0});
  std::set<Named> result;
  for (const Named& tet : tets) {
    const Vec3 first{tet[0][0], tet[0][1], tet[0][2]};
    const auto at = [&](std::size_t i) { return K::Point_3(tet[i][0], tet[i][1], tet[i][2]); };
    const auto on_sphere = std::count_if(copies.begin(), copies.end(), [&](const Vec3& p) {
      return dist_sq(first, p) < 0.25 &&
             CGAL::side_of_bounded_sphere(at(0), at(1), at(2), at(3), {p.x, p.y, p.z}) == CGAL::ON_BOUNDARY;
    });
    if (on_sphere <= 4) result.insert(tet);
  }
  return result;
}

std::vector<Vec3> random_points(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto coordinate = [&random] { return std::floor(double(random() >> 11) * 0x1p-23) * 0x1p-30; };
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.push_back({x, y, z});
  }
  return points;
}

TEST(PeriodicOracle, AgreesWithCgalButForTies) {
  const std::uint64_t seeds = std::getenv("UNSLIVER_LONG") != nullptr ? 10 : 1;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const std::size_t n : {2, 10, 30}) {
      SCOPED_TRACE(std::to_string(n) + " points, seed " + std::to_string(seed));
      MeshOptions options;
      options.strategy = Strategy::kThrifty;
      const MeshResult result =
          mesh_periodic({{0, 0, 0}, {1, 1, 1}}, *constant_size(1), random_points(n, seed), options);
      const std::vector<Vec3> points = homes(result.mesh);
      const std::set<Named> mine = ours(result.mesh), theirs = cgals(points);
      const std::set<Named> without_ties = untied(mine, points);
      EXPECT_FALSE(without_ties.empty());
      EXPECT_EQ(without_ties, untied(theirs, points));
    }
}

}  // namespace
}  // namespace unsliver
