// Every strategy's mesh of a torus is the one that the kernel makes of its vertices from scratch, ties
// included.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "delaunay/periodic_start.hpp"
#include "unsliver/periodic.hpp"

namespace unsliver {
namespace {

using delaunay::PeriodicTriangulation;
using delaunay::TetId;

/// The places of the homes and of the corners relative to the first one's, in order of homes.
using Named = std::array<std::array<double, 6>, 4>;

Named named(std::array<std::pair<Vec3, Vec3>, 4> corners) {
  std::sort(corners.begin(), corners.end(),
            [](const auto& a, const auto& b) { return lex_less(a.first, b.first); });
  Named result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [home, place] = corners[i];
    const Vec3 d = place - corners[0].second;
    result[i] = {home.x, home.y, home.z, d.x, d.y, d.z};
  }
  return result;
}

/// A mesh of lattice points alone, in units from the cell's lower corner.
struct InUnits {
  explicit InUnits(const TetMesh& mesh) : mesh_(mesh), unit_(mesh.frame->unit) {}
  Vec3 period() const { return (1 / unit_) * mesh_.periodicity->cell.size(); }
  Vec3 place(VertexId v) const { return (1 / unit_) * (mesh_.points[v] - mesh_.periodicity->cell.lo); }
  std::vector<Vec3> homes() const {
    std::vector<Vec3> places;
    for (VertexId v = 0; v < mesh_.points.size(); ++v)
      if (mesh_.periodicity->home[v] == v) places.push_back(place(v));
    return places;
  }
  std::set<Named> tets() const {
    std::set<Named> result;
    for (const auto& v : mesh_.tets) {
      std::array<std::pair<Vec3, Vec3>, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = {place(mesh_.periodicity->home[v[i]]), place(v[i])};
      result.insert(named(corners));
    }
    return result;
  }

 private:
  const TetMesh& mesh_;
  double unit_;
};

std::set<Named> tets(const PeriodicTriangulation& mesh) {
  std::set<Named> result;
  for (TetId t = 0; t < mesh.slot_count(); ++t) {
    if (!mesh.alive(t)) continue;
    std::array<std::pair<Vec3, Vec3>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId corner = mesh.tet(t).v[i];
      corners[i] = {mesh.point(mesh.vertex_of(corner)), mesh.point(corner)};
    }
    result.insert(named(corners));
  }
  return result;
}

TEST(Periodic, MeshesAreThoseOfTheKernelTiesIncluded) {
  const std::string wave = "sqrt(sin(3.14159265358979 * x)^2 + sin(3.14159265358979 * y)^2)";
  for (const Box3& cell :
       {Box3{{0, 0, 0}, {1, 1, 1}}, Box3{{0, -1, 0}, {3, 1, 4}}, Box3{{0, 0, 0}, {1, 3, 0.75}}})
    for (const SizingPtr& size : {constant_size(0.2), expression_size("0.07 + 0.15 * " + wave, cell),
                                  expression_size("0.06 + 0.3 * x", cell)})
      for (const Strategy strategy : {Strategy::kOctree, Strategy::kClosure, Strategy::kThrifty}) {
        SCOPED_TRACE(size->describe() + ", " + to_string(strategy));
        MeshOptions options;
        options.strategy = strategy;
        const MeshResult result = mesh_periodic(cell, *size, {}, options);
        const InUnits mesh(result.mesh);
        const auto kernel = delaunay::periodic_start(delaunay::Torus(mesh.period()), mesh.homes(),
                                                     [](const Tet&) { return true; });
        ASSERT_TRUE(kernel);
        EXPECT_EQ(mesh.tets(), tets(*kernel));
      }
}

TEST(Periodic, OctreesGiveTheSameForAnyNumberOfThreads) {
  const Box3 cell{{0, 0, 0}, {1, 2, 1}};
  const SizingPtr size = expression_size("0.02 + 0.1 * abs(x - 0.5)", cell);
  MeshOptions options;
  options.strategy = Strategy::kOctree;
  options.threads = 1;
  const TetMesh one = mesh_periodic(cell, *size, {}, options).mesh;
  options.threads = 3;
  const TetMesh three = mesh_periodic(cell, *size, {}, options).mesh;
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.tets, three.tets);
}

}  // namespace
}  // namespace unsliver
