// Input vertices off the grid, pinched boundaries, cover on faces, cancel, progress, caps: what a report
// says.

#include "verify/report.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "bcc_mesh.hpp"
#include "verify/kd_tree.hpp"

namespace unsliver {
namespace {

using namespace testing_verify;

bool says(const VerifyReport& r, const std::string& words) {
  return text(r).find(words) != std::string::npos;
}

/// A BCC block with one vertex made an input vertex `off` units away from its grid point.
TetMesh with_input_vertex(Vec3 off) {
  TetMesh mesh = bcc_mesh({.cells = {4, 4, 4}, .unit = 0x1p-20, .origin = {0x1p-20, 0, 0}});
  const std::size_t v = mesh.points.size() / 2;
  mesh.levels[v] = 0;
  mesh.points[v] = mesh.points[v] + 0x1p-20 * off;
  return mesh;
}

TEST(Report, InputVerticesAreJudgedRounded) {
  const VerifyReport r = verify(with_input_vertex({0.3, -0.25, 0}), guaranteed(60, 90));
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_TRUE(says(r, "1 input vertices judged at the nearest grid point, at most 0.3 units")) << text(r);
  EXPECT_EQ(r.min_dihedral_deg, 60);
}

TEST(Report, InputVerticesRoundedToAnotherPointAreJudgedThere) {
  const VerifyReport r = verify(with_input_vertex({0.7, 0, 0}), guaranteed(60, 90));
  EXPECT_GT(findings(r)["dihedral"], 0);
  EXPECT_EQ(findings(r)["lattice"], 0) << text(r);
}

TEST(Report, LatticeVerticesAreNeverRounded) {
  TetMesh mesh = with_input_vertex({0.3, -0.25, 0});
  mesh.levels[mesh.points.size() / 2] = 6;
  const VerifyReport r = verify(mesh, guaranteed(60, 90));
  EXPECT_GT(findings(r)["lattice"], 0);
  EXPECT_GT(findings(r)["dihedral"], 0);
}

TEST(Report, InversionByRoundingIsFound) {
  // Judged positions are fine; the given ones are not.
  TetMesh mesh = single_tet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  mesh.frame = Frame{1, {}};
  mesh.levels = {0, 1, 1, 0};
  EXPECT_TRUE(verify(mesh, {}).ok);
  mesh.points[0] = {0.4, 0.4, 0.4};
  const VerifyReport r = verify(mesh, {});
  EXPECT_EQ(findings(r)["orientation"], 1) << text(r);
}

TEST(Report, PinchedBoundaryIsALineNotAFinding) {
  // Two tetrahedra that share the edge 0-1 only.
  TetMesh mesh = single_tet({{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {0, 2, 0}}});
  mesh.points.push_back({-2, 0, 0});
  mesh.points.push_back({0, -2, 0});
  mesh.tets.push_back({0, 1, 4, 5});
  const VerifyReport r = verify(mesh, {});
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_TRUE(says(r, "1 edges in more than two facets")) << text(r);
}

TEST(Report, TwoTetrahedraThatAreNotDelaunay) {
  TetMesh mesh = single_tet({{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}}});
  mesh.tets[0] = {0, 1, 2, 3};
  mesh.points.push_back({4, 4, 4});
  mesh.tets.push_back({4, 1, 3, 2});
  VerifyReport r = verify(mesh, {});
  EXPECT_EQ(findings(r)["delaunay"], 1) << text(r);
  EXPECT_EQ(r.finding_count, 1u) << text(r);
  mesh.points[4] = {9, 9, 9};
  r = verify(mesh, {});
  EXPECT_TRUE(r.ok) << "on the sphere is allowed: " << text(r);
  EXPECT_TRUE(says(r, "1 facets locally Delaunay (exact), 1 ties")) << text(r);
  mesh.points[4] = {9, 9, std::nextafter(9, 0)};
  EXPECT_EQ(findings(verify(mesh, {}))["delaunay"], 1);
  mesh.points[4] = {9, 9, std::nextafter(9, 10)};
  EXPECT_TRUE(verify(mesh, {}).ok);
}

TEST(Report, GlobalDelaunayNeedsNoSharedFacet) {
  TetMesh mesh = single_tet({{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}});
  for (const Vec3 p : {Vec3{5, 5, 5}, Vec3{9, 5, 5}, Vec3{5, 9, 5}, Vec3{5, 5, 9}}) mesh.points.push_back(p);
  mesh.tets.push_back({4, 5, 6, 7});
  VerifyOptions o;
  EXPECT_TRUE(verify(mesh, o).ok);
  o.delaunay_global = true;
  EXPECT_GT(findings(verify(mesh, o))["delaunay"], 0);
}

TEST(Report, TheSizeOfADomainThatRandomPointsMissIsTestedAtItsSamples) {
  const TetMesh mesh = kuhn_mesh({.cells = {3, 3, 3}});
  VerifyOptions o;
  o.inside = [](const Vec3& p) { return std::abs(p.z - 4) < 1e-9; };
  o.size = [](const Vec3&) { return 8.0; };
  o.size_samples = 1000;
  EXPECT_EQ(findings(verify(mesh, o))["size"], 1) << "nothing was tested";
  o.must_cover = {{1, 2, 4}, {20, 11, 4}};
  EXPECT_TRUE(verify(mesh, o).ok) << text(verify(mesh, o));
  o.size = [](const Vec3&) { return 1.0; };
  EXPECT_EQ(findings(verify(mesh, o))["size"], 2);
}

TEST(Report, CoverIsClosed) {
  const TetMesh mesh = kuhn_mesh({.cells = {3, 3, 3}});
  VerifyOptions o;
  o.must_cover = mesh.points;
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    Vec3 p{double(random() % 25), double(random() % 2500) / 100, double(random() % 25)};
    if (i % 2) p[int(random() % 3)] = random() % 2 ? 0 : 24;
    o.must_cover.push_back(p);
  }
  for (Vec3& p : o.must_cover) p.y = std::min(p.y, 24.0);
  EXPECT_TRUE(verify(mesh, o).ok) << text(verify(mesh, o));
  const std::size_t covered = o.must_cover.size();
  o.must_cover.push_back({24, 12, std::nextafter(24, 25)});
  o.must_cover.push_back({-0x1p-60, 1, 1});
  o.must_cover.push_back({NAN, 1, 1});
  const VerifyReport r = verify(mesh, o);
  ASSERT_EQ(r.findings.size(), 3u) << text(r);
  for (const Finding& f : r.findings) EXPECT_GE(f.ids[0], std::int64_t(covered));
}

TEST(Report, NegativeMeshIsMeasuredAllTheSame) {
  TetMesh mesh = kuhn_mesh({.cells = {2, 2, 2}});
  for (auto& t : mesh.tets) std::swap(t[0], t[1]);
  const VerifyReport r = verify(mesh, guaranteed(45, 90));
  EXPECT_EQ(r.finding_count, mesh.tets.size());
  EXPECT_EQ(findings(r)["orientation"], 20);
  EXPECT_EQ(r.min_dihedral_deg, 45);
  EXPECT_DOUBLE_EQ(r.volume, -16.0 * 16 * 16);
}

TEST(Report, FlatTetrahedronHasTheWorstAngles) {
  const VerifyReport r = verify(single_tet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}), {});
  EXPECT_EQ(findings(r)["orientation"], 1);
  EXPECT_EQ(r.min_dihedral_deg, 0);
  EXPECT_EQ(r.max_dihedral_deg, 180);
}

TEST(Report, ExtremeScalesAreMeasured) {
  for (const double s : {1e-70, 1e70, 1e-300, 1e300}) {
    TetMesh mesh = single_tet({{{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}}});
    mesh.points.push_back({s * 0x1p-100, 0, 0});  // keeps the positions from being integers
    const VerifyReport r = verify(mesh, guaranteed());
    EXPECT_TRUE(r.ok) << text(r);
    EXPECT_NEAR(r.min_dihedral_deg, std::acos(1 / std::sqrt(3)) * 180 / std::numbers::pi, 1e-13);
    EXPECT_EQ(r.max_dihedral_deg, 90);
  }
}

TEST(Report, FindingsAreCappedAndCounted) {
  VerifyOptions o = guaranteed(61, 89);
  o.max_findings = 3;
  const TetMesh mesh = bcc_mesh();
  const VerifyReport r = verify(mesh, o);
  EXPECT_EQ(r.findings.size(), 3u);
  EXPECT_EQ(r.finding_count, 2 * mesh.tets.size());
  for (const Finding& f : r.findings) EXPECT_NE(f.message.find("degrees, "), std::string::npos);
}

TEST(Report, ChecksCanBeLeftOut) {
  TetMesh mesh = single_tet({{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}}});
  mesh.points.push_back({4, 4, 4});
  mesh.tets.push_back({4, 1, 3, 2});
  mesh.tets.push_back({4, 1, 3, 2});
  VerifyOptions o;
  o.conforming_superset = o.delaunay = false;
  EXPECT_TRUE(verify(mesh, o).ok);
  o.conforming_superset = true;
  EXPECT_GT(findings(verify(mesh, o))["conformity"], 0);
}

TEST(Report, CancelEndsSoonAndIsNotOk) {
  int polls = 0;
  const Control control{{}, [&] { return ++polls == 3; }};
  const VerifyReport r = verify(bcc_mesh({.cells = {12, 12, 12}}), guaranteed(), control);
  EXPECT_FALSE(r.ok);
  EXPECT_EQ(findings(r)["cancelled"], 1);
  EXPECT_EQ(polls, 3);
}

TEST(Report, CancelIsPolledOften) {
  std::uint64_t polls = 0;
  const Control control{{}, [&] { return ++polls == 0; }};
  const TetMesh mesh = bcc_mesh({.cells = {12, 12, 12}});
  EXPECT_TRUE(verify(mesh, guaranteed(), control).ok);
  EXPECT_GT(polls, 3 * mesh.tets.size() / 5000);
}

TEST(Report, SameSeedSameNumbers) {
  VerifyOptions o;
  o.inside = [](const Vec3&) { return true; };
  o.size = [](const Vec3&) { return 100.0; };
  o.size_samples = 500;
  const TetMesh mesh = bcc_mesh({.cells = {3, 3, 3}});
  const double first = verify(mesh, o).worst_size_ratio;
  EXPECT_EQ(verify(mesh, o).worst_size_ratio, first);
  o.seed = 2;
  EXPECT_NE(verify(mesh, o).worst_size_ratio, first);
}

TEST(Report, GroupedNumbers) {
  EXPECT_EQ(verifier::grouped(0), "0");
  EXPECT_EQ(verifier::grouped(999), "999");
  EXPECT_EQ(verifier::grouped(1000), "1,000");
  EXPECT_EQ(verifier::grouped(1980000), "1,980,000");
}

TEST(KdTree, AgreesWithLookingAtEveryPoint) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::uint64_t range = seed % 2 ? 8 : 1000;  // many equal coordinates, or few
    const auto any = [&] {
      return Vec3{double(random() % range), double(random() % range), double(random() % range)};
    };
    std::vector<Vec3> points(random() % 300 + 1);
    std::vector<VertexId> ids;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = any();
      if (i % 4) ids.push_back(VertexId(i));
    }
    const verifier::KdTree tree(points, ids);
    for (int query = 0; query < 100; ++query) {
      const Vec3 p = any(), q = any();
      const VertexId except = VertexId(random() % points.size());
      double least = INFINITY;
      std::vector<VertexId> boxed, found;
      const Box3 box{{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                     {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
      for (const VertexId id : ids) {
        if (id != except) least = std::min(least, dist_sq(points[id], p));
        if (box.contains(points[id])) boxed.push_back(id);
      }
      EXPECT_EQ(tree.nearest(p, except).dist_sq, least);
      tree.visit_box(box, [&](VertexId id, const Vec3& at) {
        EXPECT_EQ(at, points[id]);
        found.push_back(id);
      });
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, boxed);
    }
  }
}

}  // namespace
}  // namespace unsliver
