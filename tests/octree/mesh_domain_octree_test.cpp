// Octree meshes from the outside: whatever the domain and the size, the guarantees hold, judged by the
// independent verifier.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "exact/quality_signs.hpp"
#include "lattice/world.hpp"
#include "octree/octree.hpp"
#include "unsliver/error.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::octree {
namespace {

struct Job {
  std::string name;
  DomainPtr domain;
  SizingPtr size;
};

TriangleMesh tetrahedron_surface() {
  return {{{0, 0, 0}, {2, 0, 0.1}, {0.3, 1.7, 0}, {0.2, 0.3, 1.5}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          "tetrahedron"};
}

std::vector<Job> jobs() {
  const DomainPtr ball = make_ball({0.1, 0.2, 0.3}, 1);
  const DomainPtr box = make_box({{-1, 0, 2}, {1, 0.5, 3}});
  const DomainPtr unit_box = make_box({{0, 0, 0}, {1, 1, 1}});
  const DomainPtr torus =
      make_implicit("(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1", {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}});
  const DomainPtr far = make_ball({1e6, -2e6, 3e6}, 0.01);
  const DomainPtr solid = make_surface(tetrahedron_surface());
  const double inf = std::numeric_limits<double>::infinity();
  return {
      {"ball, constant", ball, constant_size(0.07)},
      {"ball, size as large as the domain", ball, constant_size(1.5)},
      {"ball, infinite size", ball, constant_size(1e300)},
      {"ball, graded from a point", ball, graded_from_points({{0.3, 0.2, 0.1}}, {0.005}, 0.2, inf)},
      {"ball, graded slowly", ball, graded_from_points({{0.3, 0.2, 0.1}}, {0.03}, 0.05, inf)},
      {"ball, graded from two points", ball,
       graded_from_points({{0.3, 0.2, 0.1}, {0.1, 0.2, 1.2}}, {0.01, 0.004}, 0.4, 0.3)},
      {"ball, formula", ball, expression_size("0.05 + 0.2 * abs(x)", ball->bounds())},
      {"ball, steep formula", ball, expression_size("0.05 + 0.9 * abs(z - 0.3)", ball->bounds())},
      {"box, constant", box, constant_size(0.05)},
      {"box on lattice planes, graded", unit_box, graded_from_points({{1, 1, 1}}, {0.01}, 0.25, inf)},
      {"box, steep size", unit_box, graded_from_points({{0.3, 0.4, 0.5}}, {0.01}, 10, 0.2)},
      {"thin plate", make_box({{0.7, 0.9, 0.3}, {1.7, 1.95, 0.319}}), constant_size(0.09)},
      {"thin bar", make_box({{0, 0, 0}, {1, 0.02, 0.03}}), constant_size(0.05)},
      {"ball, size defined in the domain alone", make_ball({0, 0, 0}, 0.5),
       expression_size("0.6 - sqrt(x^2 + y^2 + z^2)", {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}})},
      {"torus, constant", torus, constant_size(0.06)},
      {"small ball far away, constant", far, constant_size(0.001)},
      {"surface, constant", solid, constant_size(0.1)},
      {"surface, graded", solid, graded_from_surface(tetrahedron_surface(), 0.03, 0.3, inf)},
  };
}

std::vector<Vec3> points_inside(const Domain& domain, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
  const Box3 box = domain.bounds();
  std::vector<Vec3> points;
  for (std::size_t trial = 0; trial < 1000 * count && points.size() < count; ++trial) {
    const Vec3 p{box.lo.x + unit() * box.size().x, box.lo.y + unit() * box.size().y,
                 box.lo.z + unit() * box.size().z};
    if (domain.contains(p)) points.push_back(p);
  }
  return points;
}

VerifyReport judge(const Job& job, const TetMesh& mesh) {
  VerifyOptions options;
  options.guarantee = QualityGuarantee{};
  options.delaunay_global = mesh.tets.size() < 20000;
  options.size = [&](const Vec3& p) { return job.size->at(p); };
  options.inside = [&](const Vec3& p) { return job.domain->contains(p); };
  options.size_samples = std::getenv("UNSLIVER_LONG") != nullptr ? 3000000 : 30000;
  options.must_cover = points_inside(*job.domain, 5000, 42);
  return verify(mesh, options);
}

TEST(MeshDomainOctree, KeepsEveryGuarantee) {
  for (const Job& job : jobs()) {
    for (const bool all_centers : {false, true}) {
      SCOPED_TRACE(job.name + (all_centers ? ", all centres" : ""));
      OctreeOptions options;
      options.all_centers = all_centers;
      const OctreeResult result = mesh_domain_octree(*job.domain, *job.size, options);
      EXPECT_EQ(result.status, OctreeStatus::kDone);
      EXPECT_FALSE(result.mesh.tets.empty());
      const VerifyReport report = judge(job, result.mesh);
      EXPECT_TRUE(report.ok);
      for (const Finding& finding : report.findings)
        ADD_FAILURE() << finding.check << ": " << finding.message;
    }
  }
}

TEST(MeshDomainOctree, KeepsTheTetrahedraThatMeetTheDomainAndNoOthers) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const TetMesh mesh = mesh_domain_octree(*job.domain, *job.size).mesh;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) EXPECT_TRUE(job.domain->meets(mesh.corners(t)));
  }
}

TEST(MeshDomainOctree, LabelsAreCanonicalAndEveryVertexIsUsed) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const TetMesh mesh = mesh_domain_octree(*job.domain, *job.size).mesh;
    const lattice::World world(*mesh.frame);
    std::vector<bool> used(mesh.points.size(), false);
    for (const auto& t : mesh.tets)
      for (const VertexId v : t) used[v] = true;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_TRUE(used[v]);
      EXPECT_EQ(mesh.levels[v], lattice::canonical_level(world.to_world(mesh.points[v])));
    }
  }
}

TEST(MeshDomainOctree, ThreadsAndRepetitionChangeNothing) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    OctreeOptions three;
    three.threads = 3;
    const TetMesh a = mesh_domain_octree(*job.domain, *job.size).mesh;
    const TetMesh b = mesh_domain_octree(*job.domain, *job.size, three).mesh;
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.tets, b.tets);
    EXPECT_EQ(a.levels, b.levels);
  }
}

/// Vertices strictly inside, against volume / (2.862 s^3), the thinnest covering there is.
TEST(MeshDomainOctree, ConstantSizeComesNearTheThinnestCovering) {
  for (const double s : {0.02, 0.0237, 0.0281, 0.0335}) {
    SCOPED_TRACE(s);
    const TetMesh mesh = mesh_domain_octree(*make_ball({0, 0, 0}, 1), *constant_size(s)).mesh;
    const auto inside =
        std::count_if(mesh.points.begin(), mesh.points.end(), [](const Vec3& p) { return norm_sq(p) <= 1; });
    EXPECT_LT(double(inside), 1.1 * 4.18879 / (2.862 * s * s * s));
  }
}

/// Nearly all of the ball has size `cap`, which is no power of two times the least size.
TEST(MeshDomainOctree, TheUnitFitsThePlateauThatNeedsMostVertices) {
  for (const double cap : {0.03, 0.036, 0.043, 0.052}) {
    SCOPED_TRACE(cap);
    const SizingPtr size = graded_from_points({{0.1, 0.2, 0.3}}, {0.01}, 0.3, cap);
    const TetMesh mesh = mesh_domain_octree(*make_ball({0, 0, 0}, 1), *size).mesh;
    const auto inside =
        std::count_if(mesh.points.begin(), mesh.points.end(), [](const Vec3& p) { return norm_sq(p) <= 1; });
    EXPECT_LT(double(inside), 1.45 * 4.18879 / (2.862 * cap * cap * cap));
  }
}

TEST(MeshDomainOctree, CapsAndCancellationEndTheRun) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.05);
  const OctreeResult full = mesh_domain_octree(*ball, *size);
  OctreeOptions options;
  options.max_tets = full.mesh.tets.size();
  EXPECT_EQ(mesh_domain_octree(*ball, *size, options).status, OctreeStatus::kDone);
  --options.max_tets;
  const OctreeResult capped = mesh_domain_octree(*ball, *size, options);
  EXPECT_EQ(capped.status, OctreeStatus::kTetCap);
  EXPECT_EQ(capped.stats.needed_tets, full.mesh.tets.size());
  EXPECT_TRUE(capped.mesh.tets.empty() && capped.mesh.points.empty());
  options = {};
  options.max_bytes = full.stats.peak_bytes - 1;
  EXPECT_EQ(mesh_domain_octree(*ball, *size, options).status, OctreeStatus::kMemoryCap);
  Control control;
  control.cancelled = [] { return true; };
  EXPECT_EQ(mesh_domain_octree(*ball, *size, {}, control).status, OctreeStatus::kCancelled);
}

TEST(MeshDomainOctree, RefusesSizesBelowTheFinestLattice) {
  EXPECT_THROW(mesh_domain_octree(*make_ball({1e6, 0, 0}, 1e-3), *constant_size(1e-12)), Error);
  EXPECT_THROW(mesh_domain_octree(*make_ball({0, 0, 0}, 1), *constant_size(1), {.threads = 0}), Error);
}

TEST(MeshDomainOctree, SizesThatFailInsideTheDomainAreReported) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  EXPECT_THROW(mesh_domain_octree(*ball, *expression_size("x + 0.5", ball->bounds())), Error);
}

}  // namespace
}  // namespace unsliver::octree
