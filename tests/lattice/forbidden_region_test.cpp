#include "lattice/forbidden_region.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include "reference.hpp"

namespace unsliver::lattice {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Real = boost::multiprecision::cpp_bin_float_100;

TEST(ForbiddenRegion, ConstantsAreRoundedToNearest) {
  const Real sigma = (2 + sqrt(Real(6))) / 4;
  EXPECT_EQ(kSigma, sigma.convert_to<double>());
  EXPECT_EQ(kRho, Real(sqrt(Real(3)) * sigma).convert_to<double>());
}

TEST(ForbiddenRegion, HalfSideIsTheExactFloor) {
  for (int k = 0; k <= 48; ++k) {
    // n <= 2^k (2 + sqrt 6)/4 iff 4n - 2^(k+1) <= sqrt(6 * 4^k)
    const Integer square = Integer(6) << (2 * k);
    const Integer floor = ((Integer(1) << (k + 1)) + sqrt(square)) / 4;
    EXPECT_EQ(Integer(std::int64_t(half_side(k))), floor) << "k " << k;
    const Integer rest = 4 * floor - (Integer(1) << (k + 1));
    EXPECT_TRUE(rest <= 0 || rest * rest <= square);
    EXPECT_GT((rest + 4) * (rest + 4), square);
  }
}

TEST(ForbiddenRegion, IsAClosedCubeOfThatHalfSide) {
  reference::Random random(31);
  for (int i = 0; i < 20'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 90));
    const double half = half_side((level - 1) / 2);
    const Vec3 p = reference::to_vec(random.point(std::int64_t{1} << 47));
    Vec3 q = p + Vec3{double(random.integer(-1, 1)) * half, double(random.integer(-1, 1)) * half,
                      double(random.integer(-1, 1)) * half};
    EXPECT_TRUE(in_forbidden_region(p, level, q)) << "level " << level << " p " << p << " q " << q;
    const int axis = int(random.integer(0, 2));
    q[axis] = p[axis] + (random.integer(0, 1) ? half + 1 : -half - 1);
    EXPECT_FALSE(in_forbidden_region(p, level, q)) << "level " << level << " p " << p << " q " << q;
  }
}

TEST(ForbiddenRegion, IsSharedBySimpleCubicAndTheNextBodyCentred) {
  // R(p, 3) has half side floor(8.899) = 8: SC_3 and BCC_4.
  for (const Level level : {7, 8}) {
    EXPECT_TRUE(in_forbidden_region({-5, 0, 0}, level, {3, 8, -8}));
    EXPECT_FALSE(in_forbidden_region({-5, 0, 0}, level, {4, 0, 0}));
  }
  EXPECT_FALSE(in_forbidden_region({-5, 0, 0}, 6, {3, 8, -8}));
  EXPECT_TRUE(in_forbidden_region({-5, 0, 0}, 9, {4, 0, 0}));
}

}  // namespace
}  // namespace unsliver::lattice
