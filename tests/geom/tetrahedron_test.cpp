#include "geom/tetrahedron.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace unsliver::geom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
const Tet kRegular = {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}};

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double real() { return 0x1p-52 * double(bits_() >> 11) - 1; }
  Tet tet() {
    Tet t;
    for (Vec3& p : t) p = {real(), real(), real()};
    return t;
  }

 private:
  std::mt19937_64 bits_;
};

Tet mirrored(const Tet& t) { return {t[1], t[0], t[2], t[3]}; }

/// In the plane across the edge: project the two other corners and take the angle between them.
double angle_by_projection(const Tet& t, int i, int j) {
  int others[2], count = 0;
  for (int k = 0; k < 4; ++k) {
    if (k != i && k != j) others[count++] = k;
  }
  const Vec3 e = t[j] - t[i];
  const auto across = [&](int k) {
    const Vec3 a = t[k] - t[i];
    return a - dot(a, e) / norm_sq(e) * e;
  };
  const Vec3 a = across(others[0]), b = across(others[1]);
  return std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0));
}

TEST(Tetrahedron, DihedralAnglesByProjectionInTheStatedOrder) {
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const Tet t = random.tet();
    const auto angles = dihedral_angles(t);
    for (int e = 0; e < 6; ++e) {
      EXPECT_NEAR(angles[e], angle_by_projection(t, kEdges[e][0], kEdges[e][1]), 1e-5) << "tet " << i;
    }
  }
}

TEST(Tetrahedron, AnglesOfKnownShapes) {
  for (const double angle : dihedral_angles(kRegular)) EXPECT_NEAR(angle, std::acos(1.0 / 3), 1e-15);
  const Tet corner = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const double right = kPi / 2, slant = std::acos(1 / std::sqrt(3.0));
  const double expected[] = {right, right, right, slant, slant, slant};
  for (int e = 0; e < 6; ++e) EXPECT_NEAR(dihedral_angles(corner)[e], expected[e], 1e-15);
  // The tetrahedron of the BCC lattice.
  const Tet bcc = {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 1, 1}, Vec3{1, 1, -1}};
  const double sixty = kPi / 3;
  const double bcc_angles[] = {right, sixty, sixty, sixty, sixty, right};
  for (int e = 0; e < 6; ++e) EXPECT_NEAR(dihedral_angles(bcc)[e], bcc_angles[e], 1e-15);
}

TEST(Tetrahedron, AnglesIgnoreOrientationAndScale) {
  Random random(2);
  for (int i = 0; i < 1'000; ++i) {
    const Tet t = random.tet();
    auto sorted = dihedral_angles(t), other = dihedral_angles(mirrored(t));
    std::sort(sorted.begin(), sorted.end());
    std::sort(other.begin(), other.end());
    Tet large = t;
    for (Vec3& p : large) p = 0x1p180 * p;
    EXPECT_EQ(dihedral_angles(large), dihedral_angles(t));
    for (int e = 0; e < 6; ++e) EXPECT_NEAR(sorted[e], other[e], 1e-9);
  }
}

TEST(Tetrahedron, SmallAnglesKeepTheirDigits) {
  const double h = 1e-12;
  const Tet sliver = {Vec3{-1, 0, h}, Vec3{1, 0, h}, Vec3{0, -1, 0}, Vec3{0, 1, 0}};
  const auto angles = dihedral_angles(sliver);
  EXPECT_NEAR(angles[0], kPi - 2 * h, 1e-15);
  EXPECT_NEAR(angles[5], kPi - 2 * h, 1e-15);
  // At the sides of the square meet planes of slopes (0, +-h) and (+-h, 0).
  for (int e = 1; e < 5; ++e) EXPECT_NEAR(angles[e] / h, std::sqrt(2.0), 1e-12);
}

TEST(Tetrahedron, FlatOnesHaveAnglesZeroAndPi) {
  const Tet flat = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}};
  for (const double angle : dihedral_angles(flat)) EXPECT_TRUE(angle == 0 || angle == kPi) << angle;
  EXPECT_EQ(volume(flat), 0);
  EXPECT_EQ(radius_edge_ratio(flat), std::numeric_limits<double>::infinity());
  EXPECT_EQ(radius_edge_ratio(Tet{}), std::numeric_limits<double>::infinity());
}

TEST(Tetrahedron, CircumsphereTouchesTheCorners) {
  Random random(3);
  for (int i = 0; i < 5'000; ++i) {
    const Tet t = random.tet();
    if (std::abs(volume(t)) < 1e-2) continue;
    const Sphere sphere = circumsphere(t);
    for (const Vec3& p : t) EXPECT_NEAR(dist_sq(p, sphere.center) / sphere.radius_sq, 1, 1e-9);
    EXPECT_NEAR(volume(mirrored(t)), -volume(t), 1e-15);
  }
}

TEST(Tetrahedron, ShortestEdgeAndRatio) {
  EXPECT_EQ(shortest_edge_sq(kRegular), 8);
  EXPECT_NEAR(radius_edge_ratio(kRegular), std::sqrt(6.0) / 4, 1e-15);
  EXPECT_NEAR(volume(kRegular), volume(mirrored(kRegular)) * -1, 1e-15);
  EXPECT_NEAR(std::abs(volume(kRegular)), 8.0 / 3, 1e-15);
  for (const auto& edge : kEdges) {  // each edge in turn the shortest
    Tet t = kRegular;
    t[edge[0]] = 0.5 * (t[edge[0]] + t[edge[1]]);
    EXPECT_EQ(shortest_edge_sq(t), 2);
    EXPECT_NEAR(radius_edge_ratio(t), std::sqrt(circumsphere(t).radius_sq / 2), 1e-15);
  }
}

}  // namespace
}  // namespace unsliver::geom
