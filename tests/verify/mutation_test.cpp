// Each kind of damage, at many seeded places, must be caught by the check that is there for it.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bcc_mesh.hpp"

namespace unsliver {
namespace {

using namespace testing_verify;

/// The attained bounds of BCC: nothing may move.
VerifyOptions tight() {
  VerifyOptions o = guaranteed(60, 90, 0.6455);
  o.max_findings = 1000000;
  return o;
}

/// Runs `damage` at 20 seeded places of a fresh mesh; expects a finding of `check` every time.
template <class Damage>
void expect_caught(const std::string& check, Damage&& damage, const VerifyOptions& options = tight()) {
  const TetMesh valid = bcc_mesh({.cells = {6, 6, 6}});
  ASSERT_TRUE(verify(valid, options).ok) << text(verify(valid, options));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    TetMesh mesh = valid;
    damage(mesh, random);
    const VerifyReport r = verify(mesh, options);
    EXPECT_FALSE(r.ok);
    EXPECT_GT(findings(r)[check], 0) << text(r);
    EXPECT_EQ(r.finding_count, r.findings.size());
  }
}

std::size_t any_tet(const TetMesh& m, std::mt19937_64& random) { return random() % m.tets.size(); }
std::size_t any_point(const TetMesh& m, std::mt19937_64& random) { return random() % m.points.size(); }

TEST(Mutation, FlippedTetrahedron) {
  const auto flip = [](TetMesh& m, auto& random) {
    auto& t = m.tets[any_tet(m, random)];
    std::swap(t[random() % 2], t[2 + random() % 2]);
  };
  expect_caught("orientation", flip);
  expect_caught("conformity", flip);
}

TEST(Mutation, VertexMovedByOneUlp) {
  expect_caught("lattice", [](TetMesh& m, auto& random) {
    double& x = m.points[any_point(m, random)][int(random() % 3)];
    x = std::nextafter(x, random() % 2 ? 1e9 : -1e9);
  });
}

TEST(Mutation, VertexMovedByOneUlpWithoutLevels) {
  const auto nudge = [](TetMesh& m, auto& random) {
    m.levels.clear();
    m.frame.reset();
    double& x = m.points[any_point(m, random)][int(random() % 3)];
    x = std::nextafter(x == 0 ? 0x1p-30 : x, 1e9);
  };
  expect_caught("dihedral", nudge);
}

TEST(Mutation, VertexMovedByOneUnit) {
  const auto step = [](TetMesh& m, auto& random) {
    m.points[any_point(m, random)][int(random() % 3)] += random() % 2 ? 1 : -1;
  };
  expect_caught("lattice", step);
  expect_caught("dihedral", step);
  expect_caught("radius-edge", step);
}

TEST(Mutation, VertexMovedFarIsNotDelaunay) {
  VerifyOptions o = tight();
  o.guarantee.reset();
  const auto move = [](TetMesh& m, auto& random) {
    const auto& t = m.tets[any_tet(m, random)];
    m.levels.clear();
    m.points[t[2]] = m.points[t[2]] + 0.6 * (m.points[t[3]] - m.points[t[2]]);
  };
  expect_caught("delaunay", move, o);
}

TEST(Mutation, DeletedTetrahedronOpensTheCover) {
  VerifyOptions o = tight();
  const TetMesh valid = bcc_mesh({.cells = {6, 6, 6}});
  for (std::size_t t = 0; t < valid.tets.size(); ++t) {
    const Tet c = valid.corners(t);
    o.must_cover.push_back(0.25 * (c[0] + c[1] + c[2] + c[3]));
  }
  const double volume = verify(valid, o).volume;
  expect_caught(
      "cover",
      [&](TetMesh& m, auto& random) {
        m.tets.erase(m.tets.begin() + std::ptrdiff_t(any_tet(m, random)));
        const VerifyReport r = verify(m, o);
        EXPECT_DOUBLE_EQ(r.volume, volume - 512.0 / 12);
        EXPECT_EQ(findings(r)["cover"], 1);
      },
      o);
}

/// A tetrahedron that no point given is in.
TEST(Mutation, DeletedTetrahedronLeavesAHole) {
  VerifyOptions o = tight();
  o.inside = [](const Vec3& p) { return std::min({p.x, p.y, p.z}) >= 4 && std::max({p.x, p.y, p.z}) <= 44; };
  const auto remove = [&](TetMesh& m, auto& random) {
    std::size_t t = any_tet(m, random);
    const auto inside = [&](std::size_t tet) {
      const Tet corners = m.corners(tet);
      return std::all_of(corners.begin(), corners.end(), o.inside);
    };
    while (!inside(t)) t = any_tet(m, random);
    m.tets.erase(m.tets.begin() + std::ptrdiff_t(t));
    EXPECT_EQ(findings(verify(m, o))["cover"], 4) << "one a facet";
  };
  expect_caught("cover", remove, o);
  o.conforming_superset = false;
  TetMesh mesh = bcc_mesh({.cells = {6, 6, 6}});
  mesh.tets.erase(mesh.tets.begin() + std::ptrdiff_t(mesh.tets.size() / 2));
  EXPECT_TRUE(verify(mesh, o).ok) << "not asked for";
}

/// Two tetrahedra on either side of z = 0, with no vertex in common, and a gap between them.
VerifyReport judge_touching(double gap, double tolerance) {
  TetMesh mesh = single_tet({{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}});
  for (const Vec3 p : {Vec3{-90, -90, 0}, Vec3{-90, 200, 0}, Vec3{200, -90, 0}, Vec3{0, 0, -90}})
    mesh.points.push_back(p - Vec3{0, 0, gap});
  mesh.tets.push_back({4, 5, 6, 7});
  VerifyOptions o;
  o.inside = [](const Vec3& p) { return p.x > 0 && p.y > 0 && p.x + p.y < 7 && std::abs(p.z) < 0.5; };
  o.cover_tolerance = tolerance;
  return verify(mesh, o);
}

TEST(Mutation, AHoleIsWhereNoOtherTetrahedronIs) {
  EXPECT_TRUE(judge_touching(0, 0).ok) << text(judge_touching(0, 0));
  const VerifyReport r = judge_touching(1e-3, 0);
  ASSERT_EQ(findings(r)["cover"], 1) << text(r);
  EXPECT_EQ(r.finding_count, 1u) << text(r);
  EXPECT_EQ(r.findings[0].ids, (std::vector<std::int64_t>{0, 2, 1}));
  EXPECT_TRUE(judge_touching(1e-3, 2e-3).ok) << "within the tolerance";
}

TEST(Mutation, AHoleIsSeenAtAnyScale) {
  for (const double scale : {1e-100, 1e-6, 1e6, 1e100}) {
    TetMesh mesh = bcc_mesh({.cells = {3, 3, 3}, .frame = false});
    for (Vec3& p : mesh.points) p = scale * p;
    mesh.levels.clear();
    VerifyOptions o;
    o.inside = [scale](const Vec3& p) {
      return std::min({p.x, p.y, p.z}) >= 4 * scale && std::max({p.x, p.y, p.z}) <= 20 * scale;
    };
    EXPECT_TRUE(verify(mesh, o).ok) << scale << text(verify(mesh, o));
    const Vec3 middle = scale * Vec3{12, 12, 12};
    std::erase_if(mesh.tets, [&](const auto& t) {
      return std::any_of(t.begin(), t.end(), [&](VertexId v) { return mesh.points[v] == middle; });
    });
    EXPECT_GT(findings(verify(mesh, o))["cover"], 0) << scale;
  }
}

TEST(Mutation, DuplicatedTetrahedron) {
  expect_caught("conformity", [](TetMesh& m, auto& random) {
    auto copy = m.tets[any_tet(m, random)];
    if (random() % 2) copy = {copy[1], copy[0], copy[3], copy[2]};
    m.tets.push_back(copy);
  });
  // Alone in the mesh, and as its own mirror image.
  for (const std::array<VertexId, 4> again : {std::array<VertexId, 4>{1, 2, 0, 3}, {1, 0, 2, 3}}) {
    TetMesh mesh = single_tet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    mesh.tets.push_back(again);
    EXPECT_EQ(findings(verify(mesh, {}))["conformity"], 4);
  }
}

TEST(Mutation, SwappedVertices) {
  expect_caught("orientation", [](TetMesh& m, auto& random) {
    const auto& t = m.tets[any_tet(m, random)];
    std::swap(m.points[t[0]], m.points[t[2]]);
  });
}

TEST(Mutation, ReplacedVertex) {
  expect_caught("conformity", [](TetMesh& m, auto& random) {
    const std::size_t t = any_tet(m, random), u = any_tet(m, random);
    if (t == u) return void(m.tets.push_back(m.tets[t]));
    m.tets[t] = m.tets[u];
  });
}

TEST(Mutation, SplitVertexLeavesACrack) {
  expect_caught("conformity", [](TetMesh& m, auto& random) {
    VertexId& v = m.tets[any_tet(m, random)][random() % 4];
    m.points.push_back(m.points[v]);
    m.levels.push_back(m.levels[v]);
    v = VertexId(m.points.size() - 1);
  });
}

TEST(Mutation, TheTwoZerosAreOnePlace) {
  TetMesh mesh = single_tet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  for (const Vec3 p : {Vec3{-0.0, 0, -0.0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}})
    mesh.points.push_back(p);
  mesh.tets.push_back({4, 5, 7, 6});
  const VerifyReport r = verify(mesh, {});
  ASSERT_EQ(findings(r)["conformity"], 1) << text(r);
  EXPECT_EQ(r.findings[0].ids, (std::vector<std::int64_t>{0, 4}));
}

TEST(Mutation, NotANumber) {
  for (const double bad : {double(NAN), double(INFINITY)}) {
    expect_caught("coordinates", [bad](TetMesh& m, auto& random) {
      m.points[any_point(m, random)][int(random() % 3)] = bad;
    });
  }
  expect_caught("coordinates", [](TetMesh& m, auto&) { m.frame->unit = 0; });
  expect_caught("coordinates", [](TetMesh& m, auto&) { m.frame->origin.y = NAN; });
}

TEST(Mutation, BadIndex) {
  expect_caught("index", [](TetMesh& m, auto& random) {
    m.tets[any_tet(m, random)][random() % 4] = random() % 2 ? kNoVertex : VertexId(m.points.size());
  });
  expect_caught("index", [](TetMesh& m, auto& random) {
    auto& t = m.tets[any_tet(m, random)];
    t[0] = t[1 + random() % 3];
  });
  expect_caught("index", [](TetMesh& m, auto&) { m.levels.pop_back(); });
  expect_caught("index", [](TetMesh& m, auto&) { m.triangles.push_back({0, 1, kNoVertex}); });
}

TEST(Mutation, WrongLevel) {
  expect_caught("lattice", [](TetMesh& m, auto& random) {
    // A BCC_3 point of this block may be in SC_3 and coarser, never in all of SC_10.
    std::size_t v = any_point(m, random);
    while (m.points[v] == Vec3{}) v = any_point(m, random);
    m.levels[v] = std::uint8_t(21 + random() % 100);
  });
}

TEST(Mutation, WrongFrame) {
  expect_caught("lattice", [](TetMesh& m, auto&) { m.frame->origin.x += 1; });
  expect_caught("lattice", [](TetMesh& m, auto&) { m.frame->unit = 0.75; });
  expect_caught("lattice", [](TetMesh& m, auto&) { m.frame->unit = 1e-60; });
}

TEST(Mutation, GuaranteeTooHigh) {
  const TetMesh mesh = bcc_mesh();
  const double up = std::nextafter(60, 61), down = std::nextafter(90, 89);
  EXPECT_EQ(verify(mesh, guaranteed(60, 90)).finding_count, 0u);
  EXPECT_EQ(findings(verify(mesh, guaranteed(up, 90)))["dihedral"], 20);
  EXPECT_EQ(findings(verify(mesh, guaranteed(60, down)))["dihedral"], 20);
  EXPECT_EQ(verify(mesh, guaranteed(up, 90)).finding_count, mesh.tets.size());
  EXPECT_EQ(findings(verify(mesh, guaranteed(60, 90, std::sqrt(5.0 / 12) - 1e-15)))["radius-edge"], 20);
  EXPECT_EQ(verify(mesh, guaranteed(60, 90, std::sqrt(5.0 / 12) + 1e-15)).finding_count, 0u);
}

TEST(Mutation, MissingVertexBreaksTheSizeBound) {
  // Every point of the block is within sqrt(5)/4 of the cell side; without one vertex, some are not.
  VerifyOptions o = tight();
  o.size = [](const Vec3&) { return 8 * std::sqrt(5.0) / 4; };
  o.inside = [](const Vec3& p) { return std::min({p.x, p.y, p.z}) > 12 && std::max({p.x, p.y, p.z}) < 36; };
  o.size_samples = 20000;
  EXPECT_GT(verify(bcc_mesh({.cells = {6, 6, 6}}), o).worst_size_ratio, 0.9);
  expect_caught(
      "size",
      [](TetMesh& m, auto& random) {
        std::size_t v = any_point(m, random);
        const auto deep = [&](const Vec3& p) {
          return std::min({p.x, p.y, p.z}) >= 16 && std::max({p.x, p.y, p.z}) <= 32;
        };
        while (!deep(m.points[v])) v = any_point(m, random);
        std::erase_if(m.tets, [&](const auto& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
      },
      o);
  o.inside = [](const Vec3&) { return false; };
  EXPECT_EQ(findings(verify(bcc_mesh(), o))["size"], 1) << "an untested bound must not pass";
  o.inside = [](const Vec3&) { return true; };
  o.size = [](const Vec3&) { return NAN; };
  EXPECT_EQ(findings(verify(bcc_mesh(), o))["size"], o.size_samples);
}

TEST(Mutation, GradingBelowItsBound) {
  VerifyOptions o = tight();
  const double nearest = 8 * std::sqrt(3.0) / 2;
  o.lfs_lower_bound = [](const Vec3&) { return 2.0; };
  o.grading_constant = nearest / 2;
  const VerifyReport r = verify(bcc_mesh(), o);
  EXPECT_TRUE(r.ok) << text(r);
  EXPECT_DOUBLE_EQ(r.worst_grading, nearest / 2);
  o.grading_constant *= 1.0001;
  EXPECT_GT(findings(verify(bcc_mesh(), o))["grading"], 0);
}

TEST(Mutation, OverlapIsSeenByCoverPoints) {
  TetMesh mesh = single_tet({{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}});
  for (const Vec3 p : {Vec3{1, 1, 1}, Vec3{9, 1, 1}, Vec3{1, 9, 1}, Vec3{1, 1, 9}}) mesh.points.push_back(p);
  mesh.tets.push_back({4, 5, 6, 7});
  VerifyOptions o;
  o.must_cover = {{2, 2, 2}, {0.5, 0.5, 0.5}};
  EXPECT_EQ(findings(verify(mesh, o))["overlap"], 1);
}

/// Adds a tetrahedron whose base lies at this height, with an apex 8 above it, or below it if `down`.
void add_on_base(TetMesh& mesh, double height, bool down = false) {
  const auto first = VertexId(mesh.points.size());
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{8, 0, 0}, Vec3{0, 8, 0}, Vec3{0, 0, down ? -8.0 : 8.0}})
    mesh.points.push_back(p + Vec3{0, 0, height});
  mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  if (down) std::swap(mesh.tets.back()[1], mesh.tets.back()[2]);
}

/// Two tetrahedra that overlap in a slab, and a cover point in its middle.
int overlaps(double thickness, double tolerance) {
  TetMesh mesh;
  add_on_base(mesh, 0);
  add_on_base(mesh, thickness, true);
  VerifyOptions o;
  o.must_cover = {{1, 1, thickness / 2}};
  o.cover_tolerance = tolerance;
  const VerifyReport r = verify(mesh, o);
  EXPECT_EQ(text(r).find("1 overlaps no deeper than") == std::string::npos, findings(r)["overlap"] == 1)
      << text(r);
  EXPECT_EQ(r.finding_count, std::uint64_t(findings(r)["overlap"])) << text(r);
  return findings(r)["overlap"];
}

TEST(Mutation, AToleranceExcusesOverlapsThatThinAndNoThicker) {
  for (const double thickness : {0.5, 0.02, 0x1p-20, 0x1p-49}) {
    EXPECT_EQ(overlaps(thickness, 0), 1) << thickness;
    EXPECT_EQ(overlaps(thickness, 0.49 * thickness), 1) << thickness;
    EXPECT_EQ(overlaps(thickness, 0.5 * thickness), 0) << thickness;
    EXPECT_EQ(overlaps(thickness, 0.51 * thickness), 0) << thickness;
  }
}

TEST(Mutation, AThinOverlapHidesNoThickOne) {
  std::array<double, 3> bases{-2, -1, 0.005};
  VerifyOptions o;
  o.must_cover = {{1, 1, 0.01}};
  do {
    TetMesh mesh;
    for (const double base : bases) add_on_base(mesh, base);
    o.cover_tolerance = 0;
    EXPECT_EQ(findings(verify(mesh, o))["overlap"], 2);
    o.cover_tolerance = 0.006;
    const VerifyReport r = verify(mesh, o);
    ASSERT_EQ(findings(r)["overlap"], 1) << text(r);
    for (const std::int64_t t : r.findings[0].ids) EXPECT_LT(bases[std::size_t(t)], 0);
  } while (std::next_permutation(bases.begin(), bases.end()));
}

TEST(Mutation, AToleranceCoversPointsThatFarOutsideAndNoFarther) {
  const TetMesh mesh = single_tet({{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}});
  VerifyOptions o;
  o.must_cover = {{1, 1, -0.01}, {-0.01, -0.01, -0.01}, {8.01, 0, 0}, {3, 3, 2.01}};
  EXPECT_EQ(findings(verify(mesh, o))["cover"], 4);
  o.cover_tolerance = 0.011;
  EXPECT_EQ(findings(verify(mesh, o))["cover"], 0);
  o.cover_tolerance = 0.003;
  EXPECT_EQ(findings(verify(mesh, o))["cover"], 4);
  o.cover_tolerance = 0.004;  // the last is 0.01 / 3 away along the diagonal
  EXPECT_EQ(findings(verify(mesh, o))["cover"], 3);
}

}  // namespace
}  // namespace unsliver
