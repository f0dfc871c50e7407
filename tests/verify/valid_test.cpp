// Meshes that are right must pass, whatever their unit, origin and frame; and the large one in time.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "bcc_mesh.hpp"

namespace unsliver {
namespace {

using namespace testing_verify;

TEST(Valid, BccBlockPassesEveryDefaultCheck) {
  const TetMesh mesh = bcc_mesh();
  const VerifyReport r = verify(mesh, guaranteed());
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_EQ(r.finding_count, 0u);
  EXPECT_EQ(r.exact_decisions, 0u) << "lattice ties must be settled in doubles";
  EXPECT_GE(r.checks.size(), 8u);
}

TEST(Valid, MeasuresOfBccAreTheKnownOnes) {
  const TetMesh mesh = bcc_mesh();
  const VerifyReport r = verify(mesh, {});
  EXPECT_DOUBLE_EQ(r.min_dihedral_deg, 60);
  EXPECT_DOUBLE_EQ(r.max_dihedral_deg, 90);
  EXPECT_NEAR(r.max_radius_edge, std::sqrt(5.0 / 12), 1e-15);
  EXPECT_DOUBLE_EQ(r.volume, double(mesh.tets.size()) * 512 / 12);
}

TEST(Valid, AnyFrame) {
  for (const double unit : {1.0, 0x1p-40 * 77, 100.0, 0.1, 0x1.23456789abcdep-30}) {
    for (const double shift : {0.0, 1e3, -12345.0}) {
      BccOptions o;
      o.unit = unit;
      // Multiples of a full-mantissa unit are not doubles in general: those only stay at the origin.
      o.origin = unit < 1 && unit != 0x1p-40 * 77 ? Vec3{} : Vec3{shift * unit, -shift * unit, 0};
      TetMesh mesh = bcc_mesh(o);
      const bool inexact = unit == 0.1 || unit == 0x1.23456789abcdep-30;
      if (inexact) mesh.frame.reset(), mesh.levels.clear();
      const VerifyReport r = verify(mesh, guaranteed(30, 135));
      SCOPED_TRACE(unit);
      EXPECT_EQ(findings(r)["lattice"] + findings(r)["dihedral"] + findings(r)["conformity"], 0) << text(r);
      EXPECT_TRUE(inexact || r.ok) << text(r);
    }
  }
}

TEST(Valid, WithoutFrameIntegersAreFoundFromTheDoubles) {
  BccOptions o;
  o.frame = false;
  o.unit = 0x1p-200;
  TetMesh mesh = bcc_mesh(o);
  mesh.levels.clear();
  const VerifyReport r = verify(mesh, guaranteed());
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_EQ(r.exact_decisions, 0u);
}

TEST(Valid, CospherityIsTheNormalCaseAndCheap) {
  const VerifyReport r = verify(kuhn_mesh(), guaranteed(45, 90));
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_EQ(r.exact_decisions, 0u);
  EXPECT_DOUBLE_EQ(r.min_dihedral_deg, 45);
  EXPECT_DOUBLE_EQ(r.max_dihedral_deg, 90);
  EXPECT_NEAR(r.max_radius_edge, std::sqrt(0.75), 1e-15);
  EXPECT_DOUBLE_EQ(r.volume, 8 * 8 * 8 * 512);
}

TEST(Valid, BothLatticesAtOtherScales) {
  for (const int k : {1, 2, 17, 40}) {
    SCOPED_TRACE(k);
    for (const TetMesh& mesh :
         {bcc_mesh({.cells = {3, 4, 5}, .k = k}), kuhn_mesh({.cells = {3, 4, 5}, .k = k})}) {
      const VerifyReport r = verify(mesh, guaranteed());
      EXPECT_TRUE(r.ok) << text(r);
      EXPECT_EQ(r.exact_decisions, 0u);
    }
  }
}

TEST(Valid, TiesAreExactInPlainDoublesToo) {
  TetMesh mesh = kuhn_mesh({.cells = {3, 3, 3}, .frame = false});
  mesh.levels.clear();
  mesh.points.push_back({1e300, 1, 1e-300});  // unused, but it makes a common grid impossible
  const VerifyReport r = verify(mesh, guaranteed(45, 90));
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_GT(r.exact_decisions, 27u * 6) << "every tie needs integers here";
}

TEST(Valid, TiesAreExactFarFromTheOrigin) {
  // Differences of about 2^33 with the lowest bit set: neither small nor beyond 128 bits, then far beyond.
  for (const double side : {0x1p12 + 1, 0x1p33 + 1, 0x1p45 + 1}) {
    TetMesh mesh = kuhn_mesh({.cells = {2, 2, 2}, .k = 0, .unit = side, .origin = {3, 5, 7}, .frame = false});
    mesh.levels.clear();
    const VerifyReport r = verify(mesh, guaranteed(45, 90));
    EXPECT_TRUE(r.ok) << text(r);
    for (Vec3& p : mesh.points) {
      if (p == mesh.points[13]) p.x += 1;
    }
    EXPECT_FALSE(verify(mesh, guaranteed(45, 90)).ok);
  }
}

TEST(Valid, GlobalDelaunay) {
  VerifyOptions o = guaranteed();
  o.delaunay_global = true;
  for (const TetMesh& mesh : {bcc_mesh({.cells = {4, 4, 4}}), kuhn_mesh({.cells = {3, 3, 3}})}) {
    const VerifyReport r = verify(mesh, o);
    EXPECT_TRUE(r.ok) << text(r);
  }
}

TEST(Valid, EmptyMesh) { EXPECT_TRUE(verify({}, guaranteed()).ok); }

TEST(Valid, MillionTetrahedraInTime) {
  if (std::getenv("UNSLIVER_LONG") == nullptr) GTEST_SKIP() << "UNSLIVER_LONG is not set";
  const TetMesh mesh =
      bcc_mesh({.cells = {44, 44, 44}, .unit = 0x1p-40 * 99, .origin = {0x1p-40 * 990, 0, 0}});
  const auto start = std::chrono::steady_clock::now();
  const VerifyReport r = verify(mesh, guaranteed());
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_LT(time.count(), 2.0);
  RecordProperty("seconds", std::to_string(time.count()));
  std::cout << mesh.tets.size() << " tetrahedra in " << time.count() << " s\n" << text(r);
}

}  // namespace
}  // namespace unsliver
