// Ties and near ties at every number of bits: each stage of the judge must hand over before it errs.

#include <gtest/gtest.h>

#include <random>

#include "bcc_mesh.hpp"
#include "verify/judge.hpp"
#include "verify/orientation.hpp"

namespace unsliver {
namespace {

using namespace testing_verify;
using verifier::mp::cpp_rational;

/// Positions as integers, and as doubles that no grid holds.
std::vector<std::vector<Vec3>> both_ways(std::vector<Vec3> points) {
  std::vector<std::vector<Vec3>> ways{points};
  points.push_back({0x1p1000, 0x1p-1000, 0});
  ways.push_back(points);
  return ways;
}

std::int64_t random_odd(std::mt19937_64& random, int bits) {
  return std::int64_t(random() >> (64 - bits)) | 1 | std::int64_t{1} << (bits - 1);
}

/// u, v with u.x v.y - u.y v.x = +-1, about `bits` long: two vectors that add up to each other by turns.
std::pair<Vec3, Vec3> unimodular(std::mt19937_64& random, int bits) {
  Vec3 u{1, 0, 0}, v{0, 1, 0};
  while (std::max({u.x, u.y, v.x, v.y}) < std::ldexp(1.0, bits - 1)) {
    u = u + double(random() % 3 + 1) * v;
    std::swap(u, v);
  }
  return {u, v};
}

TEST(Stages, OrientationOfNearlyFlatTetrahedra) {
  verifier::SignCounts counts;
  int nearly_flat = 0;
  for (int bits = 3; bits <= 44; ++bits) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      SCOPED_TRACE("bits " + std::to_string(bits) + " seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      auto [u, v] = unimodular(random, bits);
      const double det_2d = double(cpp_rational(cpp_rational(u.x) * v.y - cpp_rational(u.y) * v.x));
      ASSERT_EQ(std::abs(det_2d), 1);
      u.z = double(random_odd(random, bits)), v.z = double(random_odd(random, bits));
      const double lift = double(random() % 3) - 1;
      nearly_flat += lift != 0;
      const int truth = verifier::sign(det_2d * lift);
      for (const auto& p : both_ways({{0, 0, 0}, u, v, u + v + Vec3{0, 0, lift}})) {
        const verifier::Sites sites(p);
        EXPECT_EQ(verifier::Judge(sites, {}).candidate({0, 1, 2, 3}).orientation, truth);
        EXPECT_EQ(verifier::Judge(sites, {}).candidate({2, 0, 3, 1}).orientation, -truth);
        EXPECT_EQ(verifier::orientation_sign(p[0], p[1], p[2], p[3], counts), truth);
      }
    }
  }
  EXPECT_GT(nearly_flat, 500);
}

/// One of the 48 images of p under permutations and changes of signs: all on one sphere round the origin.
Vec3 image(const Vec3& p, std::uint64_t which) {
  constexpr int kOrder[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  Vec3 q;
  for (int axis = 0; axis < 3; ++axis) {
    q[axis] = p[kOrder[which % 6][axis]] * (which / 6 >> axis & 1 ? -1 : 1);
  }
  return q;
}

TEST(Stages, InSphereOfNearlyCosphericalPoints) {
  std::uint64_t decided[3] = {0, 0, 0}, exact = 0;
  for (int bits = 3; bits <= 47; ++bits) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      SCOPED_TRACE("bits " + std::to_string(bits) + " seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      const double x = double(random_odd(random, bits)), z = double(random_odd(random, bits));
      const Vec3 on{x, 2 * x + 2, z};          // squared length: 5 x^2 + 8 x + 4 + z^2
      const Vec3 beyond{x + 2, 2 * x + 1, z};  // one more
      const bool tie = seed % 3 == 0, inverse = seed % 3 == 1;
      std::vector<Vec3> p;
      for (int i = 0; i < 4; ++i) p.push_back(image(inverse ? beyond : on, random() % 48));
      p.push_back(image(tie || inverse ? on : beyond, random() % 48));
      for (const auto& points : both_ways(p)) {
        const verifier::Sites sites(points);
        verifier::Judge judge(sites, {});
        const auto candidate = judge.candidate({0, 1, 2, 3});
        if (candidate.orientation == 0) continue;
        const int truth = tie ? 0 : inverse ? 1 : -1;
        EXPECT_EQ(judge.in_sphere(candidate, 4), truth);
        ++decided[truth + 1];
        exact += judge.exact_decisions();
      }
    }
  }
  for (const std::uint64_t n : decided) EXPECT_GT(n, 1000u);
  EXPECT_GT(exact, 1000u);
}

/// A tetrahedron at a bound, times s, with its corners in any even order; one corner moved by one unit each
/// way.
struct AtBound {
  std::array<Vec3, 4> corners;
  int corner, axis;  ///< what to move
  double narrows;    ///< the direction that breaks the bound
  QualityGuarantee guarantee;
};

const AtBound kAtBounds[] = {
    {{{{0, 0, 0}, {1, 1, 1}, {-2, 0, 2}, {-1, -1, 2}}}, 3, 0, -1, {30, 180, INFINITY}},
    {{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}}}, 3, 0, -1, {0, 135, INFINITY}},
    {{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 1, 1}}}, 1, 0, -1, {0, 180, 1.118033988749895}}};

TEST(Stages, QualityAtAndOneUnitOffItsBounds) {
  constexpr VertexId kEvenOrders[][4] = {
      {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {1, 2, 0, 3}, {3, 0, 2, 1}};
  std::uint64_t exact = 0;
  for (const AtBound& at : kAtBounds) {
    for (int bits = 2; bits <= 46; ++bits) {
      for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE("bits " + std::to_string(bits) + " seed " + std::to_string(seed));
        std::mt19937_64 random(seed);
        const double s = double(random_odd(random, bits));
        for (const int off : {0, 1, -1}) {
          std::vector<Vec3> p;
          for (const Vec3& c : at.corners) p.push_back(s * c);
          p[at.corner][at.axis] += off * at.narrows;
          for (const auto& points : both_ways(p)) {
            const verifier::Sites sites(points);
            verifier::Judge judge(sites, verifier::make_bounds(at.guarantee));
            const auto& order = kEvenOrders[random() % 5];
            const auto c = judge.candidate({order[0], order[1], order[2], order[3]});
            if (c.orientation <= 0) continue;  // s = 3 and smaller leave little room for a unit
            const auto verdict = judge.quality(c);
            const int worst = std::max({verdict.min_angle, verdict.max_angle, verdict.ratio});
            EXPECT_TRUE(worst == off || (bits <= 4 && off != 0));
            exact += judge.exact_decisions();
          }
        }
      }
    }
  }
  EXPECT_GT(exact, 1000u);
}

}  // namespace
}  // namespace unsliver
