// Figure 8 from the outside: whatever the input vertices, they are in the mesh bit for bit, the guarantees
// hold by the independent verifier, and no forbidden region of the mesh holds an input vertex.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "lattice/forbidden_region.hpp"
#include "lattice/world.hpp"
#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/verify.hpp"

namespace unsliver {
namespace {

constexpr double kNoSize = 1e100;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  Vec3 in_unit_cube() {
    const double x = unit(), y = unit(), z = unit();
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

using Points = std::vector<Vec3>;

Points random_points(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Points points(count);
  for (Vec3& p : points) p = random.in_unit_cube();
  return points;
}

struct Job {
  std::string name;
  Points inputs;
  DomainPtr domain = make_box({{0, 0, 0}, {1, 1, 1}});
  SizingPtr size = constant_size(kNoSize);
};

Points plane() {
  Points points = random_points(60, 2);
  for (Vec3& p : points) p.z = 0.3;
  return points;
}

/// So nearly a plane that the world does not see the difference, but the caller's coordinates do.
Points nearly_plane() {
  Points points = plane();
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z = 1e-41 * static_cast<double>(i % 7);
  return points;
}

Points line() {
  Points points;
  for (int i = 0; i < 30; ++i) points.push_back({0.1 + 0.025 * i, 0.2 + 0.02 * i, 0.5});
  return points;
}

Points sphere() {
  Points points = random_points(60, 3);
  for (Vec3& p : points) {
    const Vec3 d = p - Vec3{0.5, 0.5, 0.5};
    p = Vec3{0.5, 0.5, 0.5} + 0.4 / norm(d) * d;
  }
  return points;
}

Points lattice_points() {
  Points points;
  for (int i = 0; i < 64; ++i) points.push_back({0.25 * (i % 4), 0.25 * (i / 4 % 4), 0.25 * (i / 16)});
  return points;
}

Points helix() {
  Points points;
  for (int i = 0; i < 80; ++i)
    points.push_back({0.5 + 0.3 * std::cos(0.4 * i), 0.5 + 0.3 * std::sin(0.4 * i), 0.1 + 0.01 * i});
  return points;
}

/// Spacing ratios of 10^6.
Points clusters() {
  Points points = random_points(8, 4);
  const Points dust = random_points(8, 5);
  for (int i = 0; i < 8; ++i) points.push_back(Vec3{0.3, 0.4, 0.5} + 1e-6 * dust[i]);
  return points;
}

Points close_pairs() {
  Points points = random_points(6, 6);
  for (int i = 0; i < 6; ++i) points.push_back(points[i] + Vec3{1e-9, 0, 0});
  return points;
}

/// Tetrahedra whose circumspheres cancel all digits of doubles.
Points two_tight_clusters() {
  const Points dust = random_points(12, 12);
  Points points;
  for (int i = 0; i < 12; ++i) {
    const double corner = i / 6;
    points.push_back(Vec3{corner, corner, corner} + 1e-9 * dust[i]);
  }
  return points;
}

Points duplicates() {
  Points points = random_points(10, 7);
  points.insert(points.end(), points.begin(), points.end());
  points.push_back(points[3]);
  return points;
}

/// Corners, edge middles and face centres of the domain.
Points boundary() {
  Points points;
  for (int i = 0; i < 27; ++i)
    if (i != 13) points.push_back({0.5 * (i % 3), 0.5 * (i / 3 % 3), 0.5 * (i / 9)});
  return points;
}

std::vector<Job> jobs() {
  std::vector<Job> all = {
      {"one", random_points(1, 1)},
      {"two", random_points(2, 1)},
      {"three", random_points(3, 1)},
      {"ten", random_points(10, 1)},
      {"a hundred", random_points(100, 1)},
      {"plane", plane()},
      {"nearly a plane", nearly_plane(), make_box({{0, 0, 0}, {1, 1, 6e-41}})},
      {"line", line()},
      {"sphere", sphere()},
      {"lattice", lattice_points()},
      {"helix", helix()},
      {"clusters", clusters()},
      {"close pairs", close_pairs()},
      {"two tight clusters", two_tight_clusters(), make_box({{0, 0, 0}, {1.1, 1.1, 1.1}})},
      {"duplicates", duplicates()},
      {"all identical", Points(5, Vec3{0.3, 0.3, 0.3})},
      {"on the boundary", boundary()}};
  all.push_back({"constant size", random_points(20, 8)});
  all.back().size = constant_size(0.12);
  all.push_back({"graded size in a ball", random_points(20, 9), make_ball({0.5, 0.5, 0.5}, 0.9)});
  all.back().size = graded_from_points({{0.2, 0.2, 0.2}}, {0.02}, 0.3, 0.2);
  all.push_back({"slab, sizes near the spacing", random_points(40, 13), make_box({{0, 0, 0}, {1, 1, 1e-4}})});
  for (Vec3& p : all.back().inputs) p.z *= 1e-4;
  all.back().size = constant_size(0.15);
  all.push_back({"tight clusters and sizes", two_tight_clusters(), make_box({{0, 0, 0}, {1.1, 1.1, 1.1}})});
  all.back().size = constant_size(0.3);
  all.push_back({"outside the domain", random_points(15, 10), make_ball({0.5, 0.5, 0.5}, 0.3)});
  all.push_back({"far from the origin", random_points(30, 11), make_box({{1e5, 0, 0}, {1e5 + 1, 1, 1}})});
  for (Vec3& p : all.back().inputs) p.x += 1e5;
  return all;
}

MeshResult mesh(const Job& job, MeshOptions options = {}) {
  return mesh_domain(*job.domain, *job.size, job.inputs, options);
}

/// Distance to the second nearest of the inputs: lfs_i.
double lfs_of_inputs(const Points& inputs, const Vec3& p) {
  double first = std::numeric_limits<double>::infinity(), second = first;
  for (const Vec3& u : inputs) {
    const double d = dist(u, p);
    if (d < first)
      second = std::exchange(first, d);
    else
      second = std::min(second, d);
  }
  return second;
}

Points distinct(Points points) {
  std::sort(points.begin(), points.end(), lex_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void expect_verified(const Job& job, const TetMesh& mesh, const MeshOptions& asked = {}) {
  VerifyOptions options;
  options.guarantee = QualityGuarantee{asked.min_dihedral_deg, asked.max_dihedral_deg,
                                       std::max(asked.max_radius_edge, least_radius_edge(true))};
  options.delaunay_global = mesh.tets.size() < 300000;
  if (job.size->at({}) < kNoSize) options.size = [&](const Vec3& p) { return job.size->at(p); };
  options.inside = [&](const Vec3& p) { return job.domain->contains(p); };
  options.size_samples = 5000;
  const GradingGuarantee grading = grading_guarantee(asked.strategy, true);
  const auto lfs_s = lfs_lower_bound(*job.domain, *job.size, grading);
  const Points inputs = distinct(job.inputs);
  options.lfs_lower_bound = [&, lfs_s](const Vec3& p) {
    return std::min(lfs_s(p), lfs_of_inputs(inputs, p));
  };
  options.grading_constant = grading.share;
  options.must_cover = job.inputs;
  const VerifyReport report = verify(mesh, options);
  EXPECT_TRUE(report.ok);
  for (const Finding& finding : report.findings) ADD_FAILURE() << finding.check << ": " << finding.message;
}

/// The mesh's first points are the inputs, equal ones merged, in the caller's order.
void expect_inputs_kept(const Points& inputs, const TetMesh& mesh) {
  ASSERT_EQ(mesh.point_source.size(), mesh.points.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (std::find(inputs.begin(), inputs.begin() + i, inputs[i]) != inputs.begin() + i) continue;
    EXPECT_EQ(mesh.point_source[next], i);
    EXPECT_EQ(mesh.levels[next], 0);
    EXPECT_EQ(mesh.points[next++], inputs[i]);
  }
  for (; next < mesh.points.size(); ++next) EXPECT_EQ(mesh.point_source[next], -1);
}

/// The invariant of section 5, from the output alone.
void expect_regions_empty(const Points& inputs, const TetMesh& mesh) {
  const lattice::World world(*mesh.frame);
  Points places;
  for (const Vec3& u : inputs) places.push_back(world.to_world(u));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.levels[v] == 0) continue;
    const Vec3 q = world.to_world(mesh.points[v]);
    EXPECT_TRUE(lattice::on_lattice(mesh.levels[v], q)) << "vertex " << v;
    for (const Vec3& u : places)
      EXPECT_FALSE(lattice::in_forbidden_region(q, mesh.levels[v], u)) << "vertex " << v;
  }
}

void expect_all(const Job& job, const MeshOptions& options) {
  SCOPED_TRACE(job.name);
  const MeshResult result = mesh(job, options);
  EXPECT_EQ(result.status, MeshStatus::kDone);
  EXPECT_EQ(result.stats.figure_8[static_cast<std::size_t>(Subcase::k113)], 0);
  expect_verified(job, result.mesh, options);
  expect_inputs_kept(job.inputs, result.mesh);
  expect_regions_empty(job.inputs, result.mesh);
}

TEST(Figure8, ThriftyKeepsEveryGuarantee) {
  for (const Job& job : jobs()) expect_all(job, {});
}

TEST(Figure8, LiteralKeepsEveryGuarantee) {
  MeshOptions options;
  options.strategy = Strategy::kLiteral;
  for (const Job& job : jobs()) expect_all(job, options);
}

TEST(Figure8, OnOctreesKeepsEveryGuarantee) {
  MeshOptions options;
  options.strategy = Strategy::kOctree;
  for (const Job& job : jobs()) {
    if (job.name == "outside the domain")
      EXPECT_THROW(mesh(job, options), Error);
    else
      expect_all(job, options);
  }
}

/// What is there is a mesh of the domain with the input vertices, Delaunay, but of any quality.
void expect_partial(const Job& job, const MeshResult& result, MeshStatus status) {
  EXPECT_EQ(result.status, status);
  EXPECT_FALSE(result.mesh.limits);
  expect_inputs_kept(job.inputs, result.mesh);
  VerifyOptions options;
  options.guarantee = QualityGuarantee{0, 180, std::numeric_limits<double>::infinity()};
  options.delaunay_global = result.mesh.tets.size() < 300000;
  options.inside = [&](const Vec3& p) { return job.domain->contains(p); };
  options.must_cover = job.inputs;
  const VerifyReport report = verify(result.mesh, options);
  EXPECT_TRUE(report.ok);
  for (const Finding& finding : report.findings) ADD_FAILURE() << finding.check << ": " << finding.message;
}

/// Caps that end the run in the kernel, in the forest, at the end; and the caller's wish.
TEST(Figure8, ARunOnOctreesThatIsEndedEarlyLeavesAMesh) {
  Job job{"", random_points(300, 1)};
  job.size = constant_size(0.1);
  MeshOptions options;
  options.strategy = Strategy::kOctree;
  const std::size_t needed = mesh(job, options).mesh.tets.size();
  for (const std::uint64_t cap : {std::uint64_t{2000}, std::uint64_t{5000}, std::uint64_t{needed - 1}}) {
    options.max_tets = cap;
    expect_partial(job, mesh(job, options), MeshStatus::kTetCap);
  }
  options.max_tets = 0;
  job.size = constant_size(0.02);
  options.max_memory_bytes = 3'000'000;
  expect_partial(job, mesh(job, options), MeshStatus::kMemoryCap);
  options.max_memory_bytes = 0;
  int asked = 0;
  const MeshResult result =
      mesh_domain(*job.domain, *job.size, job.inputs, options, {{}, [&asked] { return ++asked == 20; }});
  expect_partial(job, result, MeshStatus::kCancelled);
}

TEST(Figure8, OnOctreesNamesItsPhases) {
  Job job{"", random_points(20, 1)};
  job.size = constant_size(0.1);
  MeshOptions options;
  options.strategy = Strategy::kOctree;
  std::vector<std::string> names;
  for (const PhaseTime& phase : mesh(job, options).stats.phases) names.push_back(phase.name);
  EXPECT_EQ(names, (std::vector<std::string>{"size", "balance", "lift", "quality", "stitch", "choose",
                                             "number", "emit"}));
}

/// Holes of one or two tetrahedra are seldom met by samples.
void expect_no_holes(const Job& job, const TetMesh& mesh) {
  VerifyOptions options;
  options.inside = [&](const Vec3& p) { return job.domain->contains(p); };
  const VerifyReport report = verify(mesh, options);
  for (const Finding& finding : report.findings) ADD_FAILURE() << finding.check << ": " << finding.message;
}

TEST(Figure8, OnOctreesLeavesNoHoles) {
  MeshOptions options;
  options.strategy = Strategy::kOctree;
  Job job{"found by review", {{0.28, 0.673, 0.153}}};
  job.size = expression_size("0.1 + 0.3 * x", job.domain->bounds());
  expect_no_holes(job, mesh(job, options).mesh);
  job.inputs = {{0.517, 0.291, 0.805}};
  expect_no_holes(job, mesh(job, options).mesh);
  const int seeds = std::getenv("UNSLIVER_LONG") != nullptr ? 1000 : 60;
  for (int seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    job.inputs = random_points(static_cast<std::size_t>(1 + seed % 5), static_cast<std::uint64_t>(seed));
    expect_no_holes(job, mesh(job, options).mesh);
  }
}

/// Points among the vertices of the forest and on them, sizes constant and graded, any number of threads.
TEST(Figure8, OnOctreesAmongManySmallTetrahedra) {
  const int seeds = std::getenv("UNSLIVER_LONG") != nullptr ? 50 : 4;
  for (int seed = 1; seed <= seeds; ++seed)
    for (const double gradation : {0.0, 0.1, 0.6}) {
      SCOPED_TRACE(std::to_string(seed) + ", gradation " + std::to_string(gradation));
      Job job{"random", random_points(40, static_cast<std::uint64_t>(seed))};
      job.size = gradation == 0 ? constant_size(0.06)
                                : graded_from_points({{0.5, 0.4, 0.3}}, {0.04}, gradation, 0.3);
      MeshOptions options;
      options.strategy = Strategy::kOctree;
      const TetMesh bulk = mesh_domain(*job.domain, *job.size, options).mesh;
      for (std::size_t v = 0; v < bulk.points.size(); v += 1 + bulk.points.size() / 20)
        if (job.domain->contains(bulk.points[v])) job.inputs.push_back(bulk.points[v]);
      expect_all(job, options);
      options.threads = 1;
      const TetMesh one = mesh(job, options).mesh;
      options.threads = 3;
      const TetMesh three = mesh(job, options).mesh;
      EXPECT_EQ(one.points, three.points);
      EXPECT_EQ(one.tets, three.tets);
      EXPECT_EQ(one.levels, three.levels);
    }
}

TEST(Figure8, RandomPointsManySeeds) {
  const int seeds = std::getenv("UNSLIVER_LONG") != nullptr ? 100 : 10;
  for (int seed = 1; seed <= seeds; ++seed)
    for (const std::size_t count : {1, 2, 3, 7, 30})
      for (const Strategy strategy : {Strategy::kLiteral, Strategy::kThrifty, Strategy::kOctree}) {
        MeshOptions options;
        options.strategy = strategy;
        expect_all({"seed " + std::to_string(seed) + ", " + std::to_string(count) + " points",
                    random_points(count, 1000 + seed)},
                   options);
      }
}

TEST(Figure8, ThriftyUsesFewVertices) {
  double literal = 0, thrifty = 0;
  for (int seed = 1; seed <= 3; ++seed) {
    const Job job{"", random_points(300, seed)};
    MeshOptions options;
    thrifty += mesh(job, options).mesh.points.size() / 900.0;
    options.strategy = Strategy::kLiteral;
    literal += mesh(job, options).mesh.points.size() / 900.0;
  }
  EXPECT_LT(thrifty, 38);  // vertices an input point
  EXPECT_LT(thrifty, 0.4 * literal);
}

TEST(Figure8, RelaxedDemandsNeedFewerVertices) {
  const Job job{"", random_points(200, 1)};
  std::size_t fewest = 0;
  for (const double angle : {10.0, 15.0, 20.0, 30.0}) {
    MeshOptions options;
    options.min_dihedral_deg = angle;
    options.max_dihedral_deg = 165 - angle;
    const TetMesh result = mesh(job, options).mesh;
    EXPECT_GT(result.points.size(), fewest) << angle;
    fewest = result.points.size();
    expect_verified(job, result, options);
  }
}

TEST(Figure8, RefusesARatioThatOnlyLatticesReach) {
  MeshOptions options;
  options.max_radius_edge = 1.2;
  EXPECT_THROW(mesh({"", random_points(3, 1)}, options), Error);
}

TEST(Figure8, RefusesDemandsThatRoundingOfInputsCouldBreak) {
  MeshOptions options;
  options.max_radius_edge = 3;
  options.min_dihedral_deg = 0.05, options.max_dihedral_deg = 179.99;
  EXPECT_THROW(mesh({"", random_points(3, 1)}, options), Error);
  options.max_dihedral_deg = 179;
  const Job job{"", random_points(3, 1)};
  expect_verified(job, mesh(job, options).mesh, options);
}

TEST(Figure8, RefusesDistinctInputsThatTheWorldCannotTell) {
  Points points = random_points(5, 1);
  points.push_back(points[2] + Vec3{1e-13, 0, 0});
  try {
    mesh({"", points});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_NE(std::string(error.what()).find("2"), std::string::npos) << error.what();
  }
}

TEST(Figure8, TheSameJobGivesTheSameMesh) {
  const Job job{"", random_points(50, 3)};
  const TetMesh a = mesh(job).mesh, b = mesh(job).mesh;
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets, b.tets);
}

TEST(Figure8, PointsOnTheBoundaryAreNotOutside) {
  Job job{"", random_points(20, 5)};
  Box3 box;
  for (const Vec3& p : job.inputs) box.extend(p);
  job.domain = make_box(box);
  EXPECT_TRUE(mesh(job).notes.empty());
  job.inputs.push_back({2, 2, 2});
  EXPECT_EQ(mesh(job).notes.size(), 1u);
}

// The figure's size step takes SC_j with the largest j such that r(SC_j) <= s(p). Here that is SC_0, whose
// eight points within s of p all have the same input vertex in their forbidden regions; the ball about p
// holds no vertex. (In units of 2^40, for integers.)
TEST(Figure8, TheFiguresOwnSizeStepWouldBreakItsInvariant) {
  const double unit = std::ldexp(1.0, 40);
  const lattice::Level sc = 2 * 40 + 1;
  const Vec3 p = unit * Vec3{0.5, 0.5, 0.5}, input = unit * Vec3{-0.05, -0.05, -0.05};
  const double s = 0.9 * unit;
  ASSERT_LE(lattice::covering_radius(sc), s);
  ASSERT_GT(lattice::covering_radius(sc + 2), s);
  EXPECT_GT(dist(p, input), s);
  for (int i = 0; i < 8; ++i) {
    const Vec3 w = unit * Vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2)};
    EXPECT_LE(dist(w, p), s);
    EXPECT_TRUE(lattice::in_forbidden_region(w, sc, input));
  }
}

TEST(Figure8, SizesBesideInputsKeepTheInvariant) {
  for (const Strategy strategy : {Strategy::kLiteral, Strategy::kThrifty})
    for (int seed = 1; seed <= 5; ++seed) {
      Job job{"seed " + std::to_string(seed), random_points(40, seed)};
      job.size = constant_size(0.1);
      MeshOptions options;
      options.strategy = strategy;
      expect_all(job, options);
    }
}

}  // namespace
}  // namespace unsliver
