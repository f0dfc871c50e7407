// The judge of periodic meshes finds what is wrong with them. The sample is made by hand: a cell of 4 x 4 x 4
// cubes of BCC, four tetrahedra around each edge of a cube between two centres.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "unsliver/verify.hpp"

namespace unsliver {
namespace {

constexpr int kCubes = 4;

/// Vertices by twice their coordinates, in the cell and beyond.
class Sample {
 public:
  Sample() {
    mesh.frame = Frame{1, {0, 0, 0}};
    mesh.periodicity.emplace().cell = {{0, 0, 0}, {2 * kCubes, 2 * kCubes, 2 * kCubes}};
    for (int x = 0; x < kCubes; ++x)
      for (int y = 0; y < kCubes; ++y)
        for (int z = 0; z < kCubes; ++z)
          for (int axis = 0; axis < 3; ++axis) add_around({2 * x, 2 * y, 2 * z}, axis);
  }
  TetMesh mesh;

 private:
  using Place = std::array<int, 3>;

  /// Between the centres on both sides of the cube's upper face along the axis, and each edge of that face.
  void add_around(const Place& cube, int axis) {
    const auto a = std::size_t(axis), b = (a + 1) % 3, c = (a + 2) % 3;
    Place below = cube, above = cube, corner = cube;
    for (std::size_t i = 0; i < 3; ++i) below[i] += 1, above[i] += 1;
    above[a] += 2;
    corner[a] += 2;
    const auto at = [&](int i, int j) {
      Place p = corner;
      p[b] += 2 * i, p[c] += 2 * j;
      return p;
    };
    const Place around[4] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
    for (int i = 0; i < 4; ++i)
      mesh.tets.push_back({id(below), id(around[i]), id(around[(i + 1) % 4]), id(above)});
  }

  VertexId id(const Place& p) {
    if (const auto found = ids_.find(p); found != ids_.end()) return found->second;
    Place home = p;
    std::array<std::int8_t, 3> shift{};
    for (std::size_t i = 0; i < 3; ++i)
      for (; home[i] >= 2 * kCubes; home[i] -= 2 * kCubes) ++shift[i];
    const VertexId at_home = home == p ? VertexId(mesh.points.size()) : id(home);
    const auto v = VertexId(mesh.points.size());
    ids_[p] = v;
    mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    mesh.levels.push_back(2);  // BCC_1
    mesh.periodicity->home.push_back(at_home);
    mesh.periodicity->shift.push_back(shift);
    return v;
  }

  std::map<Place, VertexId> ids_;
};

VerifyReport judged(const TetMesh& mesh, bool globally = false) {
  VerifyOptions options;
  options.guarantee = QualityGuarantee{};
  options.delaunay_global = globally;
  return verify(mesh, options);
}

void expect_found(const TetMesh& mesh, const std::string& check) {
  const VerifyReport report = judged(mesh);
  EXPECT_FALSE(report.ok);
  EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
    return finding.check == check;
  })) << (report.findings.empty() ? "nothing" : report.findings.front().message);
}

TEST(Periodic, AClosedMeshIsFine) {
  const VerifyReport report = judged(Sample().mesh, true);
  EXPECT_TRUE(report.ok) << report.findings.front().message;
  EXPECT_EQ(report.volume, 8 * 8 * 8);
}

TEST(Periodic, AMissingTetrahedronIsFound) {
  TetMesh mesh = Sample().mesh;
  mesh.tets.pop_back();
  expect_found(mesh, "periodic");
}

TEST(Periodic, ATetrahedronThereTwiceByACopyIsFound) {
  TetMesh mesh = Sample().mesh;
  const auto n = VertexId(mesh.points.size());
  for (const VertexId v : mesh.tets[0]) {
    mesh.points.push_back(mesh.points[v] + Vec3{0, 0, 8});
    mesh.levels.push_back(2);
    mesh.periodicity->home.push_back(mesh.periodicity->home[v]);
    mesh.periodicity->shift.push_back(mesh.periodicity->shift[v]);
    ++mesh.periodicity->shift.back()[2];
  }
  mesh.tets.push_back({n, n + 1, n + 2, n + 3});
  expect_found(mesh, "periodic");
}

TEST(Periodic, WrongHomesAndShiftsAreFound) {
  const TetMesh good = Sample().mesh;
  const auto& shifts = good.periodicity.value().shift;
  const auto moved_along_x = [](const auto& shift) { return shift[0] == 1; };
  const auto copy = VertexId(std::find_if(shifts.begin(), shifts.end(), moved_along_x) - shifts.begin());
  TetMesh mesh = good;
  mesh.periodicity->shift[copy][0] = 2;
  expect_found(mesh, "periodic");
  mesh = good;
  mesh.periodicity->home[copy] = VertexId(mesh.points.size());
  expect_found(mesh, "periodic");
  mesh = good;
  mesh.periodicity->home[0] = copy;
  expect_found(mesh, "periodic");
  mesh = good;
  mesh.periodicity->home.pop_back();
  expect_found(mesh, "periodic");
  mesh = good;
  mesh.periodicity->cell.hi.x = 9;
  expect_found(mesh, "periodic");
  mesh = good;
  mesh.levels[copy] = 1;
  expect_found(mesh, "periodic");
  mesh = good;
  mesh.frame.reset();
  expect_found(mesh, "periodic");
}

/// Half of a cell that is told to be all of it.
TEST(Periodic, ACoarseComplexIsFound) {
  TetMesh mesh = Sample().mesh;
  mesh.periodicity->cell.hi.x = 4;  // half of it: all is there twice
  for (VertexId v = 0; v < mesh.points.size(); ++v) mesh.periodicity->shift[v][0] = 0;
  expect_found(mesh, "periodic");
}

}  // namespace
}  // namespace unsliver
