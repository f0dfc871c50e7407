#include <gtest/gtest.h>

#include <set>

#include "delaunay/periodic_start.hpp"
#include "delaunay/point_sets.hpp"

namespace unsliver::delaunay {
namespace {

using test::Random;

constexpr double kCell = 0x1p14;

/// Of points that are known to be dense enough.
PeriodicTriangulation start(const Torus& torus, const std::vector<Vec3>& points) {
  return *periodic_start(torus, points, [](const Tet&) { return true; });
}

/// All points of the simple cubic lattice, `steps` along the shortest side.
std::vector<Vec3> scaffold(const Vec3& period, double step) {
  std::vector<Vec3> points;
  for (double x = 0; x < period.x; x += step)
    for (double y = 0; y < period.y; y += step)
      for (double z = 0; z < period.z; z += step) points.push_back({x, y, z});
  return points;
}

Vec3 random_in(const Vec3& period, Random& random) {
  return {test::uniform_integer(random, period.x), test::uniform_integer(random, period.y),
          test::uniform_integer(random, period.z)};
}

/// A tetrahedron of the torus, whatever frame it is seen from: its corners relative to the home of the first
/// one in lexicographic order of homes.
using Named = std::array<std::array<double, 6>, 4>;

Named named(const PeriodicTriangulation& mesh, TetId t) {
  std::array<std::pair<Vec3, Vec3>, 4> corners;  // home, place
  for (std::size_t i = 0; i < 4; ++i) {
    const VertexId corner = mesh.tet(t).v[i];
    corners[i] = {mesh.point(mesh.vertex_of(corner)), mesh.point(corner)};
  }
  std::sort(corners.begin(), corners.end(),
            [](const auto& a, const auto& b) { return lex_less(a.first, b.first); });
  Named result;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 d = corners[i].second - corners[0].second;
    result[i] = {corners[i].first.x, corners[i].first.y, corners[i].first.z, d.x, d.y, d.z};
  }
  return result;
}

std::set<Named> all_tets(const PeriodicTriangulation& mesh) {
  std::set<Named> result;
  for (TetId t = 0; t < mesh.slot_count(); ++t)
    if (mesh.alive(t)) result.insert(named(mesh, t));
  return result;
}

std::vector<Vec3> homes(const PeriodicTriangulation& mesh) {
  std::vector<Vec3> points;
  for (VertexId v = 1; v <= mesh.vertex_count(); ++v) points.push_back(mesh.point(v));
  return points;
}

/// Six times the volume; exact in doubles for these cells.
double six_volumes(const PeriodicTriangulation& mesh) {
  double sum = 0;
  for (TetId t = 0; t < mesh.slot_count(); ++t) {
    if (!mesh.alive(t)) continue;
    const Tet c = mesh.corners(t);
    sum += dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0]));
  }
  return sum;
}

struct Box {
  Vec3 period;
  double step;
};
const Box kBoxes[] = {{{kCell, kCell, kCell}, kCell / 4},
                      {{kCell, 2 * kCell, 3 * kCell}, kCell / 4},
                      {{3 * kCell, 3 * kCell, 4 * kCell}, kCell / 2}};

TEST(Periodic, FoldsALatticeIntoAClosedComplex) {
  for (const Box& box : kBoxes) {
    const std::vector<Vec3> points = scaffold(box.period, box.step);
    const PeriodicTriangulation mesh = start(Torus(box.period), points);
    EXPECT_NO_THROW(mesh.check());
    EXPECT_EQ(mesh.vertex_count(), points.size());
    EXPECT_EQ(six_volumes(mesh), 6 * box.period.x * box.period.y * box.period.z);
  }
}

TEST(Periodic, InsertionsKeepItsInvariants) {
  for (const Box& box : kBoxes)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(seed);
      PeriodicTriangulation mesh = start(Torus(box.period), scaffold(box.period, box.step));
      for (int i = 0; i < 300; ++i) {
        Vec3 p = random_in(box.period, random);
        const VertexId v = mesh.insert(p);
        EXPECT_EQ(mesh.point(v), p);
        EXPECT_EQ(mesh.insert(p + Vec3{box.period.x, -box.period.y, 0}), v) << "its copy is the same vertex";
      }
      EXPECT_NO_THROW(mesh.check());
      EXPECT_EQ(six_volumes(mesh), 6 * box.period.x * box.period.y * box.period.z);
    }
}

TEST(Periodic, IsAFunctionOfThePointSetAlone) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Vec3 period = kBoxes[seed % 3].period;
    PeriodicTriangulation mesh = start(Torus(period), scaffold(period, kBoxes[seed % 3].step));
    for (int i = 0; i < 200; ++i) {  // lattice points, so that there are ties
      Vec3 p = random_in(period, random);
      const double grid = seed % 2 ? kCell / 16 : kCell / 8;
      for (int axis = 0; axis < 3; ++axis) p[axis] = grid * std::floor(p[axis] / grid);
      mesh.insert(p);
    }
    std::vector<Vec3> points = homes(mesh);
    test::shuffle(points, random);
    EXPECT_EQ(all_tets(mesh), all_tets(start(Torus(period), points)));
  }
}

TEST(Periodic, ShiftedPointsGiveTheShiftedTetrahedra) {
  Random random(5);
  const Vec3 period = kBoxes[1].period, shift = {kCell / 2, 1.5 * kCell, kCell / 4};
  const Torus torus(period);
  std::vector<Vec3> points = scaffold(period, kBoxes[1].step), shifted;
  for (int i = 0; i < 200; ++i) points.push_back(random_in(period, random) + Vec3{0.0, 0.0, 0.0});
  std::sort(points.begin(), points.end(), lex_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const Vec3& p : points) shifted.push_back(torus.home_of(p + shift));
  std::set<Named> moved_back;
  const PeriodicTriangulation mesh = start(torus, shifted);
  for (Named tet : all_tets(mesh)) {
    std::array<std::pair<Vec3, Vec3>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = {torus.home_of(Vec3{tet[i][0], tet[i][1], tet[i][2]} - shift),
                    {tet[i][3], tet[i][4], tet[i][5]}};
    std::sort(corners.begin(), corners.end(),
              [](const auto& a, const auto& b) { return lex_less(a.first, b.first); });
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 d = corners[i].second - corners[0].second;
      tet[i] = {corners[i].first.x, corners[i].first.y, corners[i].first.z, d.x, d.y, d.z};
    }
    moved_back.insert(tet);
  }
  EXPECT_EQ(moved_back, all_tets(start(torus, points)));
}

TEST(Periodic, RefusesPointsThatLeaveLargeBallsEmpty) {
  const Torus torus(kBoxes[0].period);
  const auto any = [](const Tet&) { return true; };
  const auto none = [](const Tet&) { return false; };
  EXPECT_FALSE(periodic_start(torus, scaffold(kBoxes[0].period, kCell), any));
  EXPECT_FALSE(periodic_start(torus, scaffold(kBoxes[0].period, kCell / 4), none));
  EXPECT_TRUE(periodic_start(torus, scaffold(kBoxes[0].period, kCell / 4), any));
}

/// The conflict region of a point at the seam, left as it was.
TEST(Periodic, AbandonedCavitiesLeaveNoTrace) {
  const Vec3 period = kBoxes[0].period;
  PeriodicTriangulation mesh = start(Torus(period), scaffold(period, kBoxes[0].step));
  const std::set<Named> before = all_tets(mesh);
  Vec3 p{kCell - 1, 1, kCell - 1};
  const TetId t = mesh.walk_to(p);
  EXPECT_TRUE(mesh.in_conflict(t, p));
  mesh.carve(p, t);
  EXPECT_GT(mesh.cavity().size(), 1u);
  mesh.abandon();
  EXPECT_EQ(all_tets(mesh), before);
  EXPECT_NO_THROW(mesh.check());
}

}  // namespace
}  // namespace unsliver::delaunay
