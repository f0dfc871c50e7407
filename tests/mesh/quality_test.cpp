#include "unsliver/quality.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace unsliver {
namespace {

const Tet kBcc = {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 1, -1}, Vec3{1, 1, 1}};        // 60 and 90
const Tet kExtreme = {Vec3{0, 2, 1}, Vec3{2, 0, 1}, Vec3{3, 2, 1}, Vec3{2, 4, 3}};     // 30 to 135 exactly
const Tet kCap = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.3, 0.3, 0.01}};  // about 2 degrees
const Tet kFlat = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}};

Tet mirrored(const Tet& t) { return {t[1], t[0], t[2], t[3]}; }

TetMesh mesh_of(const std::vector<Tet>& tets, double scale = 1, const Vec3& shift = {}) {
  TetMesh mesh;
  for (const Tet& t : tets) {
    const auto first = VertexId(mesh.points.size());
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
    for (const Vec3& p : t) mesh.points.push_back(shift + scale * p);
  }
  return mesh;
}

std::uint64_t histogram_sum(const QualitySummary& s) {
  return std::accumulate(s.histogram.begin(), s.histogram.end(), std::uint64_t{0});
}

TEST(Quality, EmptyMesh) {
  const QualitySummary s = summarize_quality(TetMesh{});
  EXPECT_EQ(s.tets, 0U);
  EXPECT_EQ(s.volume, 0);
  EXPECT_EQ(histogram_sum(s), 0U);
  EXPECT_TRUE(s.worst.empty());
  EXPECT_TRUE(min_dihedral_angles_deg(TetMesh{}).empty());
}

TEST(Quality, OfTheBodyCentredTetrahedron) {
  const QualitySummary s = summarize_quality(mesh_of({kBcc}));
  EXPECT_NEAR(s.min_dihedral_deg, 60, 1e-12);
  EXPECT_NEAR(s.max_dihedral_deg, 90, 1e-12);
  EXPECT_NEAR(s.max_radius_edge, std::sqrt(15.0) / 6, 1e-15);
  EXPECT_NEAR(s.volume, 2.0 / 3, 1e-15);
  EXPECT_EQ(s.histogram[12], 4U);
  EXPECT_EQ(s.histogram[18], 2U);
  EXPECT_EQ(histogram_sum(s), 6U);
}

// The guarantee's own extremes must not be reported as violations, in whatever units they are written.
TEST(Quality, ExactExtremesAreWithinBoundsInEveryFrame) {
  for (const double scale : {1.0, 0.1, 77.0, 1e-120, 1e150, 0x1p-1040, 1e306}) {
    for (const double shift : {0.0, 0.3}) {
      const TetMesh mesh = mesh_of({kExtreme}, scale, scale * Vec3{shift, -shift, shift});
      const QualitySummary s = summarize_quality(mesh);
      SCOPED_TRACE(testing::Message() << "scale " << scale << " shift " << shift);
      EXPECT_NEAR(s.min_dihedral_deg, 30, 1e-10);
      EXPECT_NEAR(s.max_dihedral_deg, 135, 1e-10);
      EXPECT_EQ(s.outside_30_135, 0U);
      EXPECT_EQ(s.below, (std::array<std::uint64_t, 5>{0, 0, 0, 0, 0}));
      EXPECT_EQ(s.histogram[6], 1U);
      EXPECT_EQ(s.histogram[26], 1U) << "135 is within the guarantee";
      EXPECT_EQ(s.histogram[27], 0U);
    }
  }
}

TEST(Quality, CountsBadInvertedAndFlat) {
  const TetMesh mesh = mesh_of({kBcc, kExtreme, mirrored(kExtreme), kCap, kFlat, mirrored(kCap)});
  const QualitySummary s = summarize_quality(mesh, 0);
  const QualitySummary one = summarize_quality(mesh_of({kExtreme}));
  EXPECT_EQ(s.tets, 6U);
  EXPECT_EQ(s.flat, 1U);
  EXPECT_EQ(s.inverted, 2U);
  EXPECT_EQ(s.outside_30_135, 3U);
  EXPECT_EQ(s.below, (std::array<std::uint64_t, 5>{3, 3, 3, 3, 3}));
  EXPECT_EQ(s.min_dihedral_deg, 0);
  EXPECT_EQ(s.max_dihedral_deg, 180);
  EXPECT_EQ(s.max_radius_edge, std::numeric_limits<double>::infinity());
  EXPECT_EQ(histogram_sum(s), 36U);
  EXPECT_GE(s.histogram[35], 2U) << "180 degrees belong to the last bin";
  EXPECT_TRUE(s.worst.empty());
  EXPECT_NEAR(s.volume, 2.0 / 3 + 2 * one.volume + 2 * 0.01 / 6, 1e-14);
}

TEST(Quality, WorstAreTheSmallestAnglesInOrderTiesById) {
  std::mt19937_64 bits(5);
  const auto real = [&] { return 0x1p-53 * double(bits() >> 11); };
  std::vector<Tet> tets;
  for (int i = 0; i < 500; ++i) {
    Tet t;
    for (Vec3& p : t) p = {real(), real(), real()};
    tets.push_back(t);
    if (i % 3 == 0) tets.push_back(t);
  }
  const TetMesh mesh = mesh_of(tets);
  const std::vector<float> angles = min_dihedral_angles_deg(mesh);
  ASSERT_EQ(angles.size(), tets.size());
  std::vector<std::size_t> order(tets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return angles[a] < angles[b]; });
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{40}, tets.size() + 9}) {
    const QualitySummary s = summarize_quality(mesh, count);
    ASSERT_EQ(s.worst.size(), std::min(count, tets.size()));
    for (std::size_t i = 0; i < s.worst.size(); ++i) {
      EXPECT_EQ(s.worst[i].tet, order[i]);
      EXPECT_FLOAT_EQ(float(s.worst[i].min_dihedral_deg), angles[order[i]]);
      EXPECT_EQ(s.worst[i].corners, mesh.corners(order[i]));
      EXPECT_LE(s.worst[i].radius_edge, s.max_radius_edge);
    }
  }
}

// Repeated shapes are remembered: nothing may depend on it.
TEST(Quality, TetrahedraCountAsTheyDoAlone) {
  std::mt19937_64 bits(6);
  const auto integer = [&](int count) { return double(bits() % unsigned(count)); };
  const Tet shapes[] = {kBcc, kExtreme, mirrored(kExtreme), kFlat};
  std::vector<Tet> tets;
  for (int i = 0; i < 15000; ++i) {
    Tet t = shapes[bits() % 4];
    const Vec3 shift = {integer(50), integer(50), integer(50)};
    for (Vec3& p : t) p = p + shift;
    if (i / 5000 == 1) t[0].x += 1e-3 * integer(1000000);
    tets.push_back(t);
  }
  const TetMesh mesh = mesh_of(tets);
  const QualitySummary all = summarize_quality(mesh);
  const std::vector<float> angles = min_dihedral_angles_deg(mesh);
  QualitySummary sum;
  for (std::size_t i = 0; i < tets.size(); ++i) {
    const TetMesh alone = mesh_of({tets[i]});
    const QualitySummary one = summarize_quality(alone);
    for (std::size_t j = 0; j < sum.histogram.size(); ++j) sum.histogram[j] += one.histogram[j];
    for (std::size_t j = 0; j < sum.below.size(); ++j) sum.below[j] += one.below[j];
    sum.outside_30_135 += one.outside_30_135;
    sum.inverted += one.inverted;
    sum.flat += one.flat;
    sum.volume += one.volume;
    sum.min_dihedral_deg = std::min(sum.min_dihedral_deg, one.min_dihedral_deg);
    sum.max_dihedral_deg = std::max(sum.max_dihedral_deg, one.max_dihedral_deg);
    sum.max_radius_edge = std::max(sum.max_radius_edge, one.max_radius_edge);
    ASSERT_EQ(angles[i], min_dihedral_angles_deg(alone)[0]) << "tetrahedron " << i;
  }
  EXPECT_EQ(all.histogram, sum.histogram);
  EXPECT_EQ(all.below, sum.below);
  EXPECT_EQ(all.outside_30_135, sum.outside_30_135);
  EXPECT_EQ(all.inverted, sum.inverted);
  EXPECT_EQ(all.flat, sum.flat);
  EXPECT_EQ(all.volume, sum.volume);
  EXPECT_EQ(all.min_dihedral_deg, sum.min_dihedral_deg);
  EXPECT_EQ(all.max_dihedral_deg, sum.max_dihedral_deg);
  EXPECT_EQ(all.max_radius_edge, sum.max_radius_edge);
}

TEST(Quality, BelowCountsTetrahedraOnceAtEachLimit) {
  // Two faces meeting at a given angle along the x axis, all other angles larger.
  const auto wedge = [](double deg) {
    const double a = deg * 3.14159265358979323846 / 180, h = std::tan(a / 2);
    return Tet{Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, -h}, Vec3{0, 1, h}};
  };
  const TetMesh mesh = mesh_of({wedge(4), wedge(7), wedge(12), wedge(17), wedge(25), wedge(31)});
  const QualitySummary s = summarize_quality(mesh);
  EXPECT_NEAR(s.min_dihedral_deg, 4, 1e-9);
  EXPECT_EQ(s.below, (std::array<std::uint64_t, 5>{1, 2, 3, 4, 5}));
  EXPECT_EQ(s.outside_30_135, 5U);
}

}  // namespace
}  // namespace unsliver
