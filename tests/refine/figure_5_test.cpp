// Figure 5 from the outside: whatever the domain and the size, the guarantees hold, judged by the independent
// verifier.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/verify.hpp"

namespace unsliver {
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

/// Sizes on the unit tetrahedron, and on another away from it: outside both, s jumps where they are as near.
SizingPtr sizes_at_nodes(bool with_second) {
  NodalField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  field.mesh.tets = {{0, 1, 2, 3}};
  field.values = {0.08, 0.2, 0.3, 0.25};
  if (!with_second) return background_size(std::move(field));
  for (const Vec3& p : {Vec3{1, 1, 1}, Vec3{0.7, 1, 1}, Vec3{1, 0.7, 1}, Vec3{1, 1, 0.7}})
    field.mesh.points.push_back(p), field.values.push_back(0.1);
  field.mesh.tets.push_back({4, 5, 6, 7});
  return background_size(std::move(field));
}

std::vector<Job> jobs() {
  const DomainPtr ball = make_ball({0.1, 0.2, 0.3}, 1);
  const DomainPtr box = make_box({{-1, 0, 2}, {1, 0.5, 3}});
  const DomainPtr torus =
      make_implicit("(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1", {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}});
  const DomainPtr far = make_ball({1e6, -2e6, 3e6}, 0.01);
  const DomainPtr solid = make_surface(tetrahedron_surface());
  const double inf = std::numeric_limits<double>::infinity();
  return {
      {"ball, constant", ball, constant_size(0.15)},
      {"ball, size as large as the domain", ball, constant_size(1.5)},
      {"ball, infinite size", ball, constant_size(1e300)},
      {"ball, graded from a point", ball, graded_from_points({{0.3, 0.2, 0.1}}, {0.01}, 0.3, inf)},
      {"ball, formula", ball, expression_size("0.1 + 0.2 * abs(x)", ball->bounds())},
      {"ball, steep formula", ball, expression_size("0.05 + 0.9 * abs(z - 0.3)", ball->bounds())},
      {"box, constant", box, constant_size(0.1)},
      // A size vertex can leave the tetrahedron that asked for it alive: it must be searched again.
      {"thin plate",
       make_box({{0.73817776765331389, 0.99450090048793105, 0.30474947156716298},
                 {1.73817776765331389, 1.94839390048793105, 0.32361897156716298}}),
       constant_size(0.0921217559594256)},
      {"thin bar", make_box({{0, 0, 0}, {1, 0.02, 0.03}}), constant_size(0.07)},
      {"ball, size defined in the domain alone", make_ball({0, 0, 0}, 0.5),
       expression_size("0.6 - sqrt(x^2 + y^2 + z^2)", {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}})},
      {"box, steep size", make_box({{0, 0, 0}, {1, 1, 1}}),
       graded_from_points({{0.3, 0.4, 0.5}}, {0.01}, 10, 0.3)},
      {"box that reaches past the size mesh", make_box({{-0.2, 0, 0}, {1, 1, 1}}), sizes_at_nodes(false)},
      {"box between two size meshes", make_box({{0, 0, 0}, {1, 1, 1}}), sizes_at_nodes(true)},
      {"torus, constant", torus, constant_size(0.12)},
      {"small ball far away, constant", far, constant_size(0.002)},
      {"surface, constant", solid, constant_size(0.2)},
      {"surface, graded", solid, graded_from_surface(tetrahedron_surface(), 0.06, 0.4, inf)},
  };
}

std::vector<Vec3> points_inside(const Domain& domain, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const Box3 box = domain.bounds();
  std::vector<Vec3> points;
  for (std::size_t trial = 0; trial < 1000 * count && points.size() < count; ++trial) {
    const Vec3 p{box.lo.x + unit() * box.size().x, box.lo.y + unit() * box.size().y,
                 box.lo.z + unit() * box.size().z};
    if (domain.contains(p)) points.push_back(p);
  }
  return points;
}

VerifyReport judge(const Job& job, const TetMesh& mesh, Strategy strategy) {
  VerifyOptions options;
  options.guarantee = QualityGuarantee{};
  options.delaunay_global = mesh.tets.size() < 20000;
  options.size = [&](const Vec3& p) { return job.size->at(p); };
  options.inside = [&](const Vec3& p) { return job.domain->contains(p); };
  options.size_samples = std::getenv("UNSLIVER_LONG") != nullptr ? 1000000 : 20000;
  const GradingGuarantee grading = grading_guarantee(strategy);
  options.lfs_lower_bound = lfs_lower_bound(*job.domain, *job.size, grading);
  options.grading_constant = grading.share;
  options.must_cover = points_inside(*job.domain, 5000, 42);
  return verify(mesh, options);
}

void expect_verified(const Job& job, const TetMesh& mesh, Strategy strategy) {
  EXPECT_FALSE(mesh.tets.empty());
  const VerifyReport report = judge(job, mesh, strategy);
  EXPECT_TRUE(report.ok);
  for (const Finding& finding : report.findings) ADD_FAILURE() << finding.check << ": " << finding.message;
}

MeshOptions with(Strategy strategy) {
  MeshOptions options;
  options.strategy = strategy;
  return options;
}

TEST(Figure5, ThriftyKeepsEveryGuarantee) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const MeshResult result = mesh_domain(*job.domain, *job.size, with(Strategy::kThrifty));
    EXPECT_EQ(result.status, MeshStatus::kDone);
    expect_verified(job, result.mesh, Strategy::kThrifty);
  }
}

TEST(Figure5, LiteralKeepsEveryGuarantee) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const MeshResult result = mesh_domain(*job.domain, *job.size, with(Strategy::kLiteral));
    expect_verified(job, result.mesh, Strategy::kLiteral);
  }
}

TEST(Figure5, OctreesKeepEveryGuaranteeToo) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const MeshResult result = mesh_domain(*job.domain, *job.size, with(Strategy::kOctree));
    EXPECT_EQ(result.stats.strategy, Strategy::kOctree);
    expect_verified(job, result.mesh, Strategy::kOctree);
  }
}

TEST(Figure5, ClosureKeepsEveryGuaranteeToo) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const MeshResult result = mesh_domain(*job.domain, *job.size, with(Strategy::kClosure));
    EXPECT_EQ(result.stats.quality_insertions, 0U);
    expect_verified(job, result.mesh, Strategy::kClosure);
  }
}

TEST(Figure5, AutoChoosesByGradingAndLimits) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const auto used = [&](const SizingPtr& size, const MeshOptions& options = {}) {
    return mesh_domain(*ball, *size, options).stats.strategy;
  };
  const auto graded = [](double gradation) { return graded_from_points({{0, 0, 1}}, {0.1}, gradation, 1); };
  EXPECT_EQ(used(constant_size(0.2)), Strategy::kOctree);
  EXPECT_EQ(used(graded(0.04)), Strategy::kOctree);
  EXPECT_EQ(used(graded(0.2)), Strategy::kClosure);
  MeshOptions relaxed;
  relaxed.min_dihedral_deg = 15;
  EXPECT_EQ(used(graded(0.2), relaxed), Strategy::kThrifty);
}

TEST(Figure5, ThriftyNeedsFewerVerticesThanLiteral) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  for (const SizingPtr& size : {constant_size(0.1), graded_from_points({{0, 0, 1}}, {0.03}, 0.2, 1e300)}) {
    const std::size_t thrifty_count = mesh_domain(*ball, *size, with(Strategy::kThrifty)).mesh.points.size();
    const std::size_t literal_count = mesh_domain(*ball, *size, with(Strategy::kLiteral)).mesh.points.size();
    EXPECT_LT(thrifty_count, 0.8 * static_cast<double>(literal_count)) << size->describe();
  }
}

TEST(Figure5, TheSameJobGivesTheSameMesh) {
  const Job job = jobs()[3];
  const TetMesh a = mesh_domain(*job.domain, *job.size).mesh;
  const TetMesh b = mesh_domain(*job.domain, *job.size).mesh;
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets, b.tets);
  EXPECT_EQ(a.levels, b.levels);
}

TEST(Figure5, ConstantSizeInALargeBallComesNearTheThinnestCovering) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const double s = 0.03;
  const double ideal = 4.18879 / (2.862 * s * s * s);
  for (const Strategy strategy : {Strategy::kThrifty, Strategy::kOctree}) {
    const TetMesh mesh = mesh_domain(*ball, *constant_size(s), with(strategy)).mesh;
    const double used = static_cast<double>(mesh.points.size());
    EXPECT_LT(used / ideal, 1.25) << to_string(strategy);
    EXPECT_GT(used / ideal, 0.95) << to_string(strategy);
  }
}

TEST(Figure5, LatticeTiesStayInTheCheapExactStage) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const MeshStats stats = mesh_domain(*ball, *constant_size(0.06), with(Strategy::kThrifty)).stats;
  EXPECT_GT(stats.insphere_tie, 10000u);
  EXPECT_EQ(stats.insphere_wide, 0u);
}

TEST(Figure5, RelaxedDemandsNeedFewerVertices) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = graded_from_points({{0, 0, 1}}, {0.02}, 0.5, 1e300);
  MeshOptions relaxed;
  relaxed.min_dihedral_deg = 15;
  relaxed.max_dihedral_deg = 150;
  relaxed.max_radius_edge = 1.5;
  const MeshResult result = mesh_domain(*ball, *size, relaxed);
  EXPECT_LT(result.mesh.points.size(), mesh_domain(*ball, *size).mesh.points.size());
  VerifyOptions options;
  options.guarantee = QualityGuarantee{15, 150, 1.5};
  EXPECT_TRUE(verify(result.mesh, options).ok);
}

TEST(Figure5, AFinishedMeshSaysWhatItWasHeldTo) {
  MeshOptions options;
  options.min_dihedral_deg = 20;
  for (const Strategy strategy : {Strategy::kThrifty, Strategy::kLiteral, Strategy::kOctree}) {
    options.strategy = strategy;
    const MeshResult result = mesh_domain(*make_ball({0, 0, 0}, 1), *constant_size(0.5), options);
    EXPECT_EQ(result.mesh.limits, (QualityLimits{20, 135, least_radius_edge(false)}));
  }
}

TEST(Figure5, RefusesDemandsThatNoTheoremBacks) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.5);
  const auto refused = [&](double min_angle, double max_angle, double ratio) {
    MeshOptions options;
    options.min_dihedral_deg = min_angle;
    options.max_dihedral_deg = max_angle;
    options.max_radius_edge = ratio;
    try {
      mesh_domain(*ball, *size, options);
    } catch (const Error& error) {
      return error.code() == ErrorCode::kBadOption;
    }
    return false;
  };
  EXPECT_TRUE(refused(31, 135, 1.2));
  EXPECT_TRUE(refused(30, 134, 1.2));
  EXPECT_TRUE(refused(30, 135, 1.1));
  EXPECT_TRUE(refused(std::nan(""), 135, 1.2));
  EXPECT_FALSE(refused(0, 180, 10));
}

TEST(Figure5, ACapEndsTheRunWithAValidMesh) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  MeshOptions options = with(Strategy::kThrifty);
  options.max_tets = 5000;
  const MeshResult result = mesh_domain(*ball, *constant_size(0.02), options);
  EXPECT_EQ(result.status, MeshStatus::kTetCap);
  EXPECT_LT(result.stats.total_tets, 8000u);
  EXPECT_TRUE(verify(result.mesh, VerifyOptions{}).ok);
}

TEST(Figure5, CancelIsHeardSoon) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  int polls = 0;
  Control control;
  control.cancelled = [&] { return ++polls >= 3; };
  const MeshOptions options = with(Strategy::kThrifty);
  EXPECT_EQ(mesh_domain(*ball, *constant_size(0.02), options, control).status, MeshStatus::kCancelled);
  EXPECT_EQ(polls, 3);
}

TEST(Figure5, ASizeThatIsNotPositiveInsideIsReportedWithItsPlace) {
  const DomainPtr box = make_box({{0, 0, 0}, {1, 1, 1}});
  for (const Strategy strategy : {Strategy::kLiteral, Strategy::kThrifty, Strategy::kOctree}) {
    try {
      mesh_domain(*box, *expression_size("x - 0.25", box->bounds()), with(strategy));
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput) << error.what();
    }
  }
}

TEST(Figure5, ASizeThatDoublesCannotResolveIsRefused) {
  const DomainPtr far = make_ball({1e9, 0, 0}, 1);
  const SizingPtr tiny = graded_from_points({{1e9, 0, 0}}, {1e-9}, 0.5, 1e300);
  for (const Strategy strategy : {Strategy::kLiteral, Strategy::kThrifty, Strategy::kOctree})
    EXPECT_THROW(mesh_domain(*far, *tiny, with(strategy)), Error) << to_string(strategy);
}

TEST(Estimate, IsGoodToAFactorOfTwo) {
  for (const Job& job : jobs()) {
    SCOPED_TRACE(job.name);
    const double estimated = estimate_size(*job.domain, *job.size, {}).tets;
    const double made = static_cast<double>(mesh_domain(*job.domain, *job.size).mesh.tets.size());
    if (made < 5000) continue;
    EXPECT_LT(estimated, 2 * made);
    EXPECT_GT(estimated, 0.5 * made);
  }
}

}  // namespace
}  // namespace unsliver
