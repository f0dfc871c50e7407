#include <gtest/gtest.h>

#include "domain/sample_surfaces.hpp"
#include "unsliver/domain.hpp"

namespace unsliver {
namespace {

using samples::box_surface;
using samples::joined;
using samples::sphere_surface;

const Box3 kUnit{{0, 0, 0}, {1, 1, 1}};

TEST(SurfaceDefects, NoneInCleanSurfaces) {
  for (const TriangleMesh& m : {box_surface(kUnit, 4), sphere_surface({5, 5, 5}, 2, 9)}) {
    const SurfaceDefects d = inspect_surface(m);
    EXPECT_TRUE(d.clean());
    EXPECT_EQ(d.components, 1u);
    EXPECT_EQ(d.duplicate_points.count, 0u);
    EXPECT_EQ(d.inward_components, 0u);
    EXPECT_GT(d.signed_volume, 0);
  }
}

TEST(SurfaceDefects, AHoleHasABoundary) {
  TriangleMesh m = box_surface(kUnit, 4);
  m.triangles.pop_back();
  const SurfaceDefects d = inspect_surface(m);
  EXPECT_EQ(d.boundary_edges.count, 3u);
  ASSERT_EQ(d.boundary_edges.first.size(), 3u);
  EXPECT_EQ(d.boundary_edges.first[0].size(), 2u);
  EXPECT_FALSE(d.closed());
  EXPECT_FALSE(d.clean());
}

TEST(SurfaceDefects, AFlippedTriangleIsInconsistentAtItsEdges) {
  TriangleMesh m = box_surface(kUnit, 4);
  std::swap(m.triangles[7][0], m.triangles[7][1]);
  const SurfaceDefects d = inspect_surface(m);
  EXPECT_EQ(d.inconsistent_edges.count, 3u);
  EXPECT_EQ(d.boundary_edges.count, 0u);
  EXPECT_FALSE(d.clean());
}

TEST(SurfaceDefects, CubesThatShareAnEdge) {
  const TriangleMesh m = joined(box_surface(kUnit), box_surface({{1, 1, 0}, {2, 2, 1}}));
  const SurfaceDefects d = inspect_surface(m);
  EXPECT_EQ(d.non_manifold_edges.count, 1u);
  EXPECT_EQ(d.duplicate_points.count, 2u);
  EXPECT_EQ(d.components, 1u);
  EXPECT_EQ(d.self_intersections.count, 0u);
  EXPECT_TRUE(d.closed());
  EXPECT_FALSE(d.clean());
}

TEST(SurfaceDefects, DuplicateAndDegenerateTriangles) {
  TriangleMesh m = box_surface(kUnit);
  m.triangles.push_back({m.triangles[2][1], m.triangles[2][2], m.triangles[2][0]});
  m.triangles.push_back({0, 0, 1});
  const SurfaceDefects d = inspect_surface(m);
  EXPECT_EQ(d.duplicate_triangles.count, 1u);
  EXPECT_EQ(d.duplicate_triangles.first.at(0), (std::vector<std::int64_t>{2, 12}));
  EXPECT_EQ(d.degenerate_triangles.count, 1u);
  EXPECT_EQ(d.degenerate_triangles.first.at(0), (std::vector<std::int64_t>{13}));
}

/// A zero-area triangle alone does no harm.
TEST(SurfaceDefects, DegenerateTrianglesLeaveASurfaceClean) {
  TriangleMesh m = box_surface(kUnit);
  m.triangles.push_back({0, 0, 1});
  EXPECT_TRUE(inspect_surface(m).clean());
  EXPECT_EQ(make_surface(m)->notes().size(), 1u);
}

TEST(SurfaceDefects, CrossingSurfacesAreFound) {
  const TriangleMesh a = box_surface(kUnit);
  EXPECT_GT(inspect_surface(joined(a, box_surface({{0.5, 0.5, 0.5}, {2, 2, 2}}))).self_intersections.count,
            0u);
  EXPECT_EQ(inspect_surface(joined(a, box_surface({{1.5, 1.5, 1.5}, {2, 2, 2}}))).self_intersections.count,
            0u);
  // Face on face, with other vertices: touching counts.
  EXPECT_GT(
      inspect_surface(joined(a, box_surface({{1, 0.25, 0.25}, {2, 0.75, 0.75}}))).self_intersections.count,
      0u);
  const SurfaceDefects d = inspect_surface(joined(sphere_surface({}, 1, 6), sphere_surface({1, 0, 0}, 1, 6)));
  EXPECT_GT(d.self_intersections.count, 10u);
  EXPECT_EQ(d.self_intersections.first.size(), 10u);
  EXPECT_TRUE(d.self_intersections_complete);
  EXPECT_EQ(d.components, 2u);
}

TEST(SurfaceDefects, InwardSurfaces) {
  const TriangleMesh inner = samples::inside_out(box_surface({{0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}}));
  const SurfaceDefects d = inspect_surface(joined(box_surface(kUnit), inner));
  EXPECT_EQ(d.inward_components, 1u);
  EXPECT_NEAR(d.signed_volume, 1 - 1.0 / 64, 1e-12);
  EXPECT_TRUE(d.clean());
  EXPECT_LT(inspect_surface(inner).signed_volume, 0);
}

TEST(SurfaceDefects, TrianglesAreTurnedToAgree) {
  TriangleMesh m = joined(sphere_surface({}, 1, 8), samples::inside_out(sphere_surface({}, 0.5, 6)));
  samples::Dice dice(3);
  for (std::size_t t = 0; t < 12 * 8 * 8; ++t)
    if (dice.below(2) == 1) std::swap(m.triangles[t][0], m.triangles[t][2]);
  EXPECT_GT(inspect_surface(m).inconsistent_edges.count, 300u);
  const DomainPtr domain = make_surface(m);
  ASSERT_EQ(domain->notes().size(), 2u);
  EXPECT_NE(domain->notes()[0].find("were turned"), std::string::npos) << domain->notes()[0];
  EXPECT_NE(domain->notes()[1].find("1 of 2 components face inward"), std::string::npos)
      << domain->notes()[1];
  EXPECT_TRUE(domain->contains({0.7, 0, 0}));
  EXPECT_FALSE(domain->contains({0.1, 0, 0}));
  EXPECT_FALSE(domain->contains({1.1, 0, 0}));
}

/// A Moebius band cannot agree: it stays as it is, and is covered.
TEST(SurfaceDefects, AMoebiusBandStaysInconsistent) {
  TriangleMesh m;
  constexpr VertexId kSteps = 24;
  for (VertexId i = 0; i < kSteps; ++i) {
    const double a = 6.283185307179586 * i / kSteps;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(a / 2);
      m.points.push_back({r * std::cos(a), r * std::sin(a), w * std::sin(a / 2)});
    }
  }
  for (VertexId i = 0; i < kSteps; ++i) {
    const bool last = i + 1 == kSteps;
    const VertexId a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    m.triangles.push_back({a, b, c});
    m.triangles.push_back({c, b, d});
  }
  EXPECT_GT(inspect_surface(m).inconsistent_edges.count, 0u);
  const DomainPtr domain = make_surface(m);
  EXPECT_NE(domain->notes().at(0).find("opposite orientation"), std::string::npos) << domain->notes()[0];
  for (const Vec3& p : m.points)
    EXPECT_TRUE(domain->meets(
        {{p + Vec3{-0.1, -0.1, -0.1}, p + Vec3{0.3, 0, 0}, p + Vec3{0, 0.3, 0}, p + Vec3{0, 0, 0.3}}}));
}

TEST(SurfaceDefects, NotesNameEachDefect) {
  TriangleMesh m = joined(box_surface(kUnit), box_surface({{1, 1, 0}, {2, 2, 1}}));
  m.triangles.pop_back();
  m.triangles.push_back({0, 0, 1});
  const std::vector<std::string> notes = make_surface(samples::inside_out(m))->notes();
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_NE(notes[0].find("3 boundary edges"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("1 non-manifold edge"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("inside out"), std::string::npos) << notes[1];
  EXPECT_NE(notes[2].find("2 points"), std::string::npos) << notes[2];
  EXPECT_NE(notes[3].find("1 triangle of zero area"), std::string::npos) << notes[3];
}

}  // namespace
}  // namespace unsliver
