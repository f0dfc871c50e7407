/// \file
/// What every sizing function promises, checked by sampling.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unsliver/error.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3 in(const Box3& b) {
    return {uniform(b.lo.x, b.hi.x), uniform(b.lo.y, b.hi.y), uniform(b.lo.z, b.hi.z)};
  }
  /// Of any scale from the whole box down to 2^-20 of it, sometimes a point or flat.
  Box3 box_in(const Box3& b) {
    Box3 r;
    r.extend(in(b));
    const double scale = b.longest_side() * std::ldexp(1.0, -static_cast<int>(below(20)));
    const double flat = below(4) == 0 ? 0 : 1;
    r.extend(r.lo + Vec3{uniform(0, scale), flat * uniform(0, scale), uniform(0, scale)});
    return r;
  }

 private:
  std::mt19937_64 engine_;
};

/// A point of the box: a corner, or anywhere.
inline Vec3 point_of(const Box3& b, Random& random) {
  if (random.below(4) != 0) return random.in(b);
  return {random.below(2) ? b.lo.x : b.hi.x, random.below(2) ? b.lo.y : b.hi.y,
          random.below(2) ? b.lo.z : b.hi.z};
}

/// lower_bound is positive, never above a value in the box; the Lipschitz constants are never exceeded.
inline void expect_sound(const Sizing& s, const Box3& region, int boxes = 2000) {
  for (int seed = 1; seed <= boxes; ++seed) {
    SCOPED_TRACE(testing::Message() << s.describe() << ", seed " << seed);
    Random random(static_cast<std::uint64_t>(seed));
    const Box3 box = random.box_in(region);
    const double bound = s.lower_bound(box), steepest_here = s.lipschitz_over(box);
    ASSERT_LE(steepest_here, s.lipschitz());
    ASSERT_GT(bound, 0);
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = point_of(box, random), q = point_of(i % 2 ? box : region, random);
      const double lipschitz = i % 2 ? steepest_here : s.lipschitz();
      const double at_p = s.at(p), at_q = s.at(q);
      ASSERT_LE(bound, at_p) << "p = " << p.x << " " << p.y << " " << p.z;
      if (!std::isfinite(lipschitz) || std::isinf(at_p) || std::isinf(at_q)) continue;
      ASSERT_LE(std::fabs(at_p - at_q), lipschitz * dist(p, q) * (1 + 1e-9) + 1e-12 * (at_p + at_q));
    }
  }
}

/// The bound over a box of side h is within `steepness` * h of the value at its centre.
inline void expect_tight(const Sizing& s, const Box3& region, double steepness, double slack = 1e-12) {
  for (int seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(testing::Message() << s.describe() << ", seed " << seed);
    Random random(static_cast<std::uint64_t>(seed));
    const double h = region.longest_side() * std::ldexp(1.0, -6 - static_cast<int>(random.below(14)));
    const Vec3 p = random.in(region), half{h / 2, h / 2, h / 2};
    ASSERT_GE(s.lower_bound({p - half, p + half}), s.at(p) - steepness * h - slack);
  }
}

/// Runs `make`, expects an Error of this code whose message holds `words`, and returns it.
template <class F>
Error expect_error(F make, ErrorCode code, const std::string& words) {
  try {
    make();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), code) << e.what();
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    return e;
  }
  ADD_FAILURE() << "no error; expected \"" << words << "\"";
  return Error(ErrorCode::kInternal, "");
}

}  // namespace unsliver::test
