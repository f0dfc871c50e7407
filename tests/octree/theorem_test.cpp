// The theorem of docs/CLOSURE.md: its finite parts by enumeration, and the whole of it on random closed sets.
#include <gtest/gtest.h>

#include <random>

#include "delaunay/triangulation.hpp"
#include "exact/predicates.hpp"
#include "exact/quality_signs.hpp"
#include "lattice/parents.hpp"

namespace unsliver::octree {
namespace {

exact::StageCounts counts;

/// Integer points q != 0 with coordinates of magnitude up to `reach` that satisfy the condition.
template <class Condition>
std::vector<Vec3> points_around_origin(int reach, const Condition& condition) {
  std::vector<Vec3> points;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -reach; z <= reach; ++z)
        if ((x != 0 || y != 0 || z != 0) && condition(x, y, z))
          points.push_back({double(x), double(y), double(z)});
  return points;
}

/// Calls visit(t) for each positively oriented tetrahedron of the origin and three of the points.
template <class Visit>
void for_each_tet_at_origin(const std::vector<Vec3>& points, const Visit& visit) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        Tet t{Vec3{}, points[i], points[j], points[k]};
        const int sign = exact::orient3d(t[0], t[1], t[2], t[3], counts);
        if (sign == 0) continue;
        if (sign < 0) std::swap(t[2], t[3]);
        visit(t);
      }
}

/// The circumcentre, t at the origin, times 2 det (which is positive). Exact for small integers.
Vec3 circumcenter_times_2_det(const Tet& t) {
  return norm_sq(t[1]) * cross(t[2], t[3]) + norm_sq(t[2]) * cross(t[3], t[1]) +
         norm_sq(t[3]) * cross(t[1], t[2]);
}

/// Is the circumradius at most sqrt(num / den)? With t at the origin. Exact for small integers.
bool radius_at_most(const Tet& t, double num, double den) {
  const Vec3 x = circumcenter_times_2_det(t);
  const double det = dot(t[1], cross(t[2], t[3]));
  return norm_sq(x) * den <= 4 * det * det * num;
}

bool angles_within(const Tet& t, const exact::CosBound& least, const exact::CosBound& greatest) {
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (exact::compare_dihedral(t, i, j, least, counts) < 0 ||
          exact::compare_dihedral(t, i, j, greatest, counts) > 0)
        return false;
  return true;
}

// Lemma 5 of the paper, for cases (A) and (C).
TEST(Theorem, TetrahedraOfTheCubicLatticeWithSmallCircumradiusAreGood) {
  int found = 0;
  const auto points = points_around_origin(2, [](int, int, int) { return true; });
  for_each_tet_at_origin(points, [&](const Tet& t) {
    if (!radius_at_most(t, 5, 4)) return;
    ++found;
    EXPECT_FALSE(exact::is_bad(t, {}, counts));
  });
  EXPECT_EQ(found, 976);
}

// Case (B), in halves of the spacing: the finest vertex is a centre at the origin, its cell's corners are
// (+-1, +-1, +-1), points of the lattice have coordinates that are all even or all odd.
TEST(Theorem, TetrahedraAtACentreWithItsCornersOutsideAreGood) {
  const auto points =
      points_around_origin(3, [](int x, int y, int z) { return (x & 1) == (y & 1) && (y & 1) == (z & 1); });
  const auto corners = points_around_origin(1, [](int x, int y, int z) { return (x & y & z & 1) != 0; });
  ASSERT_EQ(corners.size(), 8u);
  int found = 0;
  for_each_tet_at_origin(points, [&](const Tet& t) {
    for (const Vec3& corner : corners)
      if (exact::insphere(t[0], t[1], t[2], t[3], corner, counts) > 0) return;
    ++found;
    EXPECT_TRUE(radius_at_most(t, 9, 4));
    EXPECT_TRUE(angles_within(t, {1, 1, 2}, {-1, 1, 4}));  // 45 and 120 degrees
    EXPECT_LE(exact::compare_radius_edge(t, {3, 4}, counts), 0);
  });
  EXPECT_EQ(found, 48);
}

// Bricks, see docs/CLOSURE.md: the finest vertex is the origin, the middle of an edge along x in the brick's
// upper face y = 0, and the circumcentre is beyond this face. The parents in the brick, and those corners of
// the cubes at the edge that are parents of theirs, are outside.
TEST(Theorem, TetrahedraAtABricksFaceWithCircumcentreBeyondAreGood) {
  const auto points = points_around_origin(3, [](int, int y, int) { return y <= 0; });
  const std::vector<Vec3> outside = {{1, 0, 0}, {-1, 0, 0}, {0, -1, 1}, {0, -1, -1},
                                     {1, 0, 2}, {-1, 0, 2}, {1, 0, -2}, {-1, 0, -2}};
  int found = 0;
  for_each_tet_at_origin(points, [&](const Tet& t) {
    for (const Vec3& p : outside)
      if (exact::insphere(t[0], t[1], t[2], t[3], p, counts) > 0) return;
    if (circumcenter_times_2_det(t).y <= 0) return;
    ++found;
    EXPECT_FALSE(exact::is_bad(t, {}, counts));
    EXPECT_TRUE(angles_within(t, {1, 1, 2}, {0, 1, 1}));  // 45 and 90 degrees
    EXPECT_LE(exact::compare_radius_edge(t, {13, 16}, counts), 0);
  });
  EXPECT_EQ(found, 6);
}

/// Random points in a block of SC_K, finer at random places, and what closes the set.
std::vector<Vec3> random_closed_set(std::uint64_t seed, int coarsest) {
  std::mt19937_64 random(seed);
  const auto integer = [&](std::int64_t lo, std::int64_t hi) {
    return lo + std::int64_t(random() % std::uint64_t(hi - lo + 1));
  };
  std::vector<Vec3> points;
  const double cell = std::ldexp(1.0, coarsest);
  for (int i = 0; i < 7 * 7 * 7; ++i)
    points.push_back(cell * Vec3{double(i % 7), double(i / 7 % 7), double(i / 49)});
  const std::int64_t lo = std::int64_t(2.5 * cell), hi = std::int64_t(3.5 * cell);
  for (int i = 0; i < 6; ++i) {
    const std::int64_t step = std::int64_t{1} << integer(0, coarsest - 1);
    const auto coordinate = [&] { return double(integer(lo, hi) / step * step); };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.push_back({x, y, z});
  }
  return lattice::closure(points, 2 * coarsest + 1);
}

TEST(Theorem, HoldsForRandomClosedSets) {
  std::size_t tets = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int coarsest = 2 + int(seed % 5);
    delaunay::Triangulation dt;
    dt.insert_all(random_closed_set(seed, coarsest));
    const double cell = std::ldexp(1.0, coarsest);
    for (delaunay::TetId t = 0; t < dt.slot_count(); ++t) {
      if (!dt.is_finite(t)) continue;
      EXPECT_FALSE(exact::is_bad(dt.corners(t), {}, counts)) << "cell " << cell;
      ++tets;
    }
  }
  EXPECT_GT(tets, 60u * 6 * 6 * 6 * 5);
}

/// Closed sets cut off at the faces of a brick, near which the random places are.
TEST(Theorem, HoldsForClosedSetsInBricks) {
  std::size_t tets = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int coarsest = 2 + int(seed % 5);
    const double cell = std::ldexp(1.0, coarsest);
    std::vector<Vec3> points = random_closed_set(seed, coarsest);
    const double x = 3 * cell, y = (seed / 5 % 2 == 0 ? 3 : 7) * cell,
                 z = (seed / 10 % 2 == 0 ? 3 : 7) * cell;
    std::erase_if(points, [&](const Vec3& p) { return p.x > x || p.y > y || p.z > z; });
    delaunay::Triangulation dt;
    dt.insert_all(points);
    for (delaunay::TetId t = 0; t < dt.slot_count(); ++t) {
      if (!dt.is_finite(t)) continue;
      EXPECT_FALSE(exact::is_bad(dt.corners(t), {}, counts));
      ++tets;
    }
  }
  EXPECT_GT(tets, 120u * 3 * 3 * 3 * 5);
}

/// It is the parents that matter: the same sets without one vertex that others need have bad tetrahedra.
TEST(Theorem, FailsWithoutParents) {
  const auto bad_count = [](const std::vector<Vec3>& points) {
    delaunay::Triangulation dt;
    dt.insert_all(points);
    int bad = 0;
    for (delaunay::TetId t = 0; t < dt.slot_count(); ++t)
      bad += dt.is_finite(t) && exact::is_bad(dt.corners(t), {}, counts);
    return bad;
  };
  int broken = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    std::vector<Vec3> points = random_closed_set(seed, 5);
    std::erase_if(points, [](const Vec3& p) { return lattice::canonical_level(p) == 10; });
    broken += bad_count(points) > 0;
  }
  EXPECT_GT(broken, 5);
}

}  // namespace
}  // namespace unsliver::octree
