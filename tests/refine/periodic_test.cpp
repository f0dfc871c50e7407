#include "unsliver/periodic.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>
#include <set>

#include "unsliver/error.hpp"
#include "unsliver/verify.hpp"

namespace unsliver {
namespace {

bool is_long() { return std::getenv("UNSLIVER_LONG") != nullptr; }
std::uint64_t seeds() { return is_long() ? 10 : 1; }

std::vector<Vec3> random_points(std::size_t n, const Box3& box, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const Vec3 size = box.size();
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(), y = unit(), z = unit();
    points.push_back({box.lo.x + x * size.x, box.lo.y + y * size.y, box.lo.z + z * size.z});
  }
  return points;
}

const Box3 kCube{{0, 0, 0}, {1, 1, 1}};
const Box3 kBrick{{-1, 0.5, 2}, {0.5, 1.5, 4}};  // 3 : 2 : 4 cubes of side 0.5
const Box3 kWide{{-3, -3, -3}, {3, 3, 3}};

struct NamedSize {
  std::string name;
  SizingPtr size;
};

/// Periodic on the cube, with a jump on the brick.
std::vector<NamedSize> sizes(const Box3& cell) {
  const std::string wave =
      "sqrt(sin(3.14159265358979 * x)^2 + sin(3.14159265358979 * y)^2 + sin(3.14159265358979 * z)^2)";
  return {{"constant", constant_size(0.13)},
          {"graded", expression_size("0.07 + 0.05 * " + wave, cell)},
          {"strongly varying", expression_size("0.012 + 0.15 * " + wave, cell)}};
}

MeshResult mesh(const Box3& cell, const Sizing& sizing, const std::vector<Vec3>& points, Strategy strategy) {
  MeshOptions options;
  options.strategy = strategy;
  return mesh_periodic(cell, sizing, points, options);
}

/// All that is promised of all tetrahedra.
void expect_verified(const MeshResult& result, const Sizing& sizing, bool globally = false) {
  ASSERT_EQ(result.status, MeshStatus::kDone);
  const Box3 cell = result.mesh.periodicity->cell;
  VerifyOptions options;
  options.guarantee = {30, 135, result.mesh.limits->max_radius_edge};
  options.delaunay_global = globally;
  options.size = [&](const Vec3& p) { return sizing.at(p); };
  options.inside = [&](const Vec3& p) { return cell.contains(p); };
  options.size_samples = 4000;
  const VerifyReport report = verify(result.mesh, options);
  EXPECT_TRUE(report.ok) << report.findings.front().check << ": " << report.findings.front().message;
}

TEST(Periodic, EveryElementKeepsThePromise) {
  for (const Box3& cell : {kCube, kBrick})
    for (const NamedSize& size : sizes(cell))
      for (const std::size_t n : {0, 1, 2, 10})
        for (const Strategy strategy :
             {Strategy::kLiteral, Strategy::kThrifty, Strategy::kClosure, Strategy::kOctree})
          for (std::uint64_t seed = 1; seed <= (n == 0 ? 1 : seeds()); ++seed) {
            if (n > 0 && (strategy == Strategy::kClosure || strategy == Strategy::kOctree)) continue;
            SCOPED_TRACE(size.name + ", " + std::to_string(n) + " points, " + to_string(strategy) +
                         ", seed " + std::to_string(seed) + (cell.lo.x < 0 ? ", brick" : ", cube"));
            const MeshResult result = mesh(cell, *size.size, random_points(n, kWide, seed), strategy);
            expect_verified(result, *size.size, n == 2 && size.name == "constant");
          }
}

TEST(Periodic, ManyPoints) {
  const SizingPtr coarse = constant_size(1);
  for (const std::size_t n : {1'000, 100'000}) {
    if (n > 1'000 && !is_long()) continue;
    for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
      SCOPED_TRACE(std::to_string(n) + " points, seed " + std::to_string(seed));
      const MeshResult result = mesh(kCube, *coarse, random_points(n, kCube, seed), Strategy::kThrifty);
      expect_verified(result, *coarse);
      EXPECT_EQ(std::count(result.mesh.levels.begin(), result.mesh.levels.begin() + std::ptrdiff_t(n), 0), n);
      if (is_long())
        expect_verified(mesh(kCube, *coarse, random_points(n, kCube, seed), Strategy::kLiteral), *coarse);
    }
  }
}

/// The torus's tetrahedra by the places of their homes, moved back by `shift`, and how their corners lie.
std::set<std::set<std::array<double, 6>>> torus(const TetMesh& mesh, const Vec3& shift) {
  const Periodicity& p = *mesh.periodicity;
  const Vec3 size = p.cell.size();
  const auto wrapped = [&](VertexId home) {
    std::array<double, 3> at;
    for (int axis = 0; axis < 3; ++axis) {
      at[std::size_t(axis)] = mesh.points[home][axis] - shift[axis];
      if (at[std::size_t(axis)] < p.cell.lo[axis]) at[std::size_t(axis)] += size[axis];
    }
    return at;
  };
  std::set<std::set<std::array<double, 6>>> tets;
  for (const auto& v : mesh.tets) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < 4; ++i)
      if (wrapped(p.home[v[i]]) < wrapped(p.home[v[first]])) first = i;
    std::set<std::array<double, 6>> tet;
    for (const VertexId w : v) {
      const auto at = wrapped(p.home[w]);
      const Vec3 d = mesh.points[w] - mesh.points[v[first]];
      tet.insert({at[0], at[1], at[2], d.x, d.y, d.z});
    }
    tets.insert(tet);
  }
  return tets;
}

/// 0.05 + 0.1 times the distance to the nearest copy of a centre.
class Cone final : public Sizing {
 public:
  Cone(const Vec3& center, const Vec3& period) : center_(center), period_(period) {}
  double at(const Vec3& p) const override {
    Vec3 d = p - center_;
    for (int axis = 0; axis < 3; ++axis) d[axis] -= period_[axis] * std::round(d[axis] / period_[axis]);
    return 0.05 + 0.1 * norm(d);
  }
  double lower_bound(const Box3& box) const override {
    return std::max(0.05, at(box.center()) - 0.05 * box.diagonal());
  }
  double lipschitz() const override { return 0.15; }  // more than it is: copies in other cells play no part
  std::string describe() const override { return "cone"; }

 private:
  Vec3 center_, period_;
};

TEST(Periodic, AShiftedProblemGivesTheShiftedMesh) {
  const Vec3 shift{1, 0.5, 1.5};  // of the cubes' lattice
  for (std::uint64_t seed = 1; seed <= 2 * seeds(); ++seed)
    for (const Strategy strategy : {Strategy::kLiteral, Strategy::kThrifty}) {
      SCOPED_TRACE(std::string(to_string(strategy)) + ", seed " + std::to_string(seed));
      std::vector<Vec3> points = random_points(20, kBrick, seed), shifted;
      for (Vec3& p : points) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = 0x1p-40 * std::floor(0x1p40 * p[axis]);
        shifted.push_back(p + shift);
      }
      const Cone here({0, 1, 3}, kBrick.size()), there(Vec3{0, 1, 3} + shift, kBrick.size());
      const TetMesh a = mesh(kBrick, here, points, strategy).mesh;
      const TetMesh b = mesh(kBrick, there, shifted, strategy).mesh;
      EXPECT_GT(a.tets.size(), 1000u);
      EXPECT_EQ(torus(a, {}), torus(b, shift));
    }
}

TEST(Periodic, InputVerticesAreWrappedAndMergedAcrossFaces) {
  const std::vector<Vec3> points = {
      {0.3, 0.1, 0.7}, {1.3, 0.1, -0.3}, {0, 0.5, 0.5}, {1, 0.5, 0.5}, {0.1, 0.2, 0.3}};
  const MeshResult result = mesh(kCube, *constant_size(1), points, Strategy::kThrifty);
  expect_verified(result, *constant_size(1));
  const std::vector<std::int64_t>& source = result.mesh.point_source;
  EXPECT_EQ(std::count_if(source.begin(), source.end(), [](std::int64_t i) { return i >= 0; }), 3)
      << "points 0 and 1 are one, though moving rounds, and so are points 2 and 3";
  EXPECT_EQ(result.mesh.points[0], points[0]);
  EXPECT_EQ(result.mesh.points[1], points[2]);
  EXPECT_EQ(result.mesh.points[2], points[4]);
  EXPECT_EQ(result.notes.size(), 1u);
}

/// Beside a face rounding may say that a point is a period away.
TEST(Periodic, PointsBesideFacesAreMovedIntoTheCellOnce) {
  const double above_three = 2.9999999999999996, above_five = 4.999999999999999;
  for (const auto& [cell, point] : {std::pair(Box3{{-3, 0, 0}, {3, 6, 6}}, Vec3{above_three, 1, 1}),
                                    std::pair(Box3{{-5, -5, -5}, {5, 5, 5}}, Vec3{above_five, 1, 1}),
                                    std::pair(kCube, Vec3{-5e-324, 0.5, 1})}) {
    const std::vector<Vec3> once = points_in_cell(cell, std::vector<Vec3>{point});
    EXPECT_EQ(points_in_cell(cell, once), once);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(once[0][axis], cell.lo[axis]);
      EXPECT_LT(once[0][axis], cell.hi[axis]);
    }
  }
}

TEST(Periodic, SizesMayJumpAcrossFaces) {
  const SizingPtr ramp = expression_size("0.04 + 0.2 * x", kCube);
  for (const Strategy strategy :
       {Strategy::kThrifty, Strategy::kClosure, Strategy::kLiteral, Strategy::kOctree})
    expect_verified(mesh(kCube, *ramp, {}, strategy), *ramp);
  const SizingPtr step = expression_size("0.06 + 0.1 * (x > 0.5)", kCube);
  expect_verified(mesh(kCube, *step, {}, Strategy::kThrifty), *step);
}

std::string refusal(const Box3& cell, const std::vector<Vec3>& points) {
  try {
    mesh(cell, *constant_size(1), points, Strategy::kThrifty);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(Periodic, RefusesWhatItCannotDo) {
  EXPECT_NE(refusal({{0, 0, 0}, {1, 1, 1.2345678}}, {}).find("One that will do"), std::string::npos);
  EXPECT_NE(refusal({{0, 0, 0}, {1, 1, 0x1p-9}}, {}).find("repeat the cell"), std::string::npos);
  EXPECT_NE(refusal(kCube, {{0x1p-44, 0.5, 0.5}, {1 - 0x1p-44, 0.5, 0.5}}).find("merge such points"),
            std::string::npos);
  EXPECT_THROW(mesh(kCube, *constant_size(1), {{0.5, 0.5, 0.5}}, Strategy::kClosure), Error);
  EXPECT_THROW(mesh(kCube, *constant_size(1), {{0.5, 0.5, 0.5}}, Strategy::kOctree), Error);
}

TEST(Periodic, CapsLeaveAValidMesh) {
  MeshOptions options;
  options.strategy = Strategy::kThrifty;
  options.max_tets = 5000;
  const MeshResult result = mesh_periodic(kCube, *constant_size(0.03), {}, options);
  EXPECT_EQ(result.status, MeshStatus::kTetCap);
  EXPECT_FALSE(result.mesh.limits);
  EXPECT_TRUE(verify(result.mesh, {}).ok);
}

/// Each triangle has a partner a period away, that looks the other way.
TEST(Periodic, FacesComeInPairs) {
  const TetMesh mesh =
      unsliver::mesh(kBrick, *constant_size(0.2), random_points(3, kBrick, 1), Strategy::kThrifty).mesh;
  const Periodicity& p = *mesh.periodicity;
  std::map<std::set<VertexId>, std::vector<std::size_t>> by_homes;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    by_homes[{p.home[t[0]], p.home[t[1]], p.home[t[2]]}].push_back(i);
  }
  EXPECT_EQ(boundary_facets(mesh).size(), mesh.triangles.size());
  for (const auto& [homes, pair] : by_homes) {
    ASSERT_EQ(pair.size(), 2u);
    EXPECT_EQ(mesh.triangle_labels[pair[0]] + mesh.triangle_labels[pair[1]], 28);
    for (const std::size_t i : pair) {
      const std::array<int, 3> moved = periodic_face_shift(mesh.triangle_labels[i]);
      for (const VertexId v : mesh.triangles[i]) {
        const auto& other = mesh.triangles[pair[0] + pair[1] - i];
        const auto partner =
            std::find_if(other.begin(), other.end(), [&](VertexId w) { return p.home[w] == p.home[v]; });
        for (std::size_t axis = 0; axis < 3; ++axis)
          EXPECT_EQ(p.shift[v][axis] - p.shift[*partner][axis], moved[axis]);
      }
    }
  }
}

}  // namespace
}  // namespace unsliver
