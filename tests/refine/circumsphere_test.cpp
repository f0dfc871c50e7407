// Tetrahedra whose circumspheres are known: integer points at one distance from an integer centre.
#include "refine/circumsphere.hpp"

#include <gtest/gtest.h>

#include <random>

namespace unsliver::refine {
namespace {

/// One of the 48 vectors that signs and orders make of this one.
Vec3 shuffled(Vec3 p, std::mt19937_64& random) {
  for (int axis = 0; axis < 3; ++axis) {
    if (random() % 2 == 0) p[axis] = -p[axis];
    std::swap(p[axis], p[int(random() % 3)]);
  }
  return p;
}

/// |coordinate| < 2^bits.
Vec3 integers(const std::array<int, 3>& bits, std::mt19937_64& random) {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = double(random() >> (64 - bits[std::size_t(axis)])) * (random() % 2 == 0 ? 1 : -1);
  return p;
}

/// Requires: differences up to 2^41.
bool is_flat(const Tet& t) {
  __extension__ using Wide = __int128;
  std::array<std::array<Wide, 3>, 3> d;
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) d[i][std::size_t(axis)] = Wide(t[i + 1][axis] - t[0][axis]);
  const auto minor = [&](std::size_t i, std::size_t j) { return d[1][i] * d[2][j] - d[1][j] * d[2][i]; };
  return d[0][0] * minor(1, 2) + d[0][1] * minor(2, 0) + d[0][2] * minor(0, 1) == 0;
}

TEST(Circumsphere, IsRightHoweverFlat) {
  int checked = 0, cancelling = 0;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    std::mt19937_64 random(seed);
    const auto bits = [&] { return 1 + int(random() % 40); };
    const Vec3 center = integers({40, 40, 40}, random), offset = integers({bits(), bits(), bits()}, random);
    Tet t;
    for (Vec3& corner : t) corner = center + shuffled(offset, random);
    if (is_flat(t)) continue;
    ++checked;
    const geom::Sphere plain = geom::circumsphere(t), sphere = circumsphere(t);
    const double radius = norm(offset);
    EXPECT_LE(dist(sphere.center, center), 1e-9 * radius) << "seed " << seed;
    EXPECT_NEAR(sphere.radius_sq, radius * radius, 4e-9 * radius * radius) << "seed " << seed;
    cancelling += !(dist(plain.center, center) <= 1e-9 * radius);
  }
  EXPECT_GT(checked, 5000);
  EXPECT_GT(cancelling, 10);
}

}  // namespace
}  // namespace unsliver::refine
