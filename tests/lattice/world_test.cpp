#include "lattice/world.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "reference.hpp"
#include "unsliver/error.hpp"

namespace unsliver::lattice {
namespace {

using reference::Point;
using reference::Random;
using Rational = boost::multiprecision::cpp_rational;

Box3 box_at(const Vec3& center, const Vec3& size) {
  Box3 box;
  box.extend(center - 0.5 * size);
  box.extend(center + 0.5 * size);
  return box;
}

ErrorCode code_of(const Box3& box, double fit_radius) {
  try {
    (void)World::fit(box, fit_radius);
  } catch (const Error& error) {
    EXPECT_GT(std::string(error.what()).size(), 40U);
    return error.code();
  }
  return ErrorCode::kInternal;
}

void expect_exact(const World& world, const Point& q) {
  const Vec3 x = world.to_caller(reference::to_vec(q));
  const Rational unit(world.unit());
  const Vec3 origin = world.frame().origin;
  EXPECT_EQ(Rational(x.x), Rational(origin.x) + unit * q.x);
  EXPECT_EQ(Rational(x.y), Rational(origin.y) + unit * q.y);
  EXPECT_EQ(Rational(x.z), Rational(origin.z) + unit * q.z);
  EXPECT_EQ(world.to_world(x), reference::to_vec(q));
  EXPECT_EQ(world.to_world_real(x), reference::to_vec(q));
}

void expect_exact_lattice(const World& world, Random& random) {
  const std::int64_t last = (std::int64_t{1} << 48) - (std::int64_t{1} << (world.finest_level() / 2));
  expect_exact(world, {last, -last, last});
  expect_exact(world, {-last, last, -last});
  for (int i = 0; i < 20; ++i) {
    expect_exact(world, random.lattice_point(world.finest_level()));
    expect_exact(world, random.lattice_point(Level(random.integer(world.finest_level(), kMaxLevel))));
  }
}

void expect_form(const World& world, const Box3& box) {
  int e = 0;
  const double m = 128 * std::frexp(world.unit(), &e);
  EXPECT_EQ(m, std::floor(m));
  const double span = box.longest_side() / world.unit();
  EXPECT_GE(span, 0x1p44);
  EXPECT_LE(span, 0x1p45);
  EXPECT_GE(span / power_of_two(world.finest_level() / 2), World::kMinSteps);
  for (const int axis : {0, 1, 2}) {
    const Rational steps = Rational(world.frame().origin[axis]) / (Rational(world.unit()) * Rational(0x1p40));
    EXPECT_EQ(denominator(steps), 1) << "the origin is not a round multiple of the unit";
    EXPECT_LE(std::abs(world.to_world_real(box.lo)[axis]), 0x1p44 + 0x1p39 + 1);
    EXPECT_LE(std::abs(world.to_world_real(box.hi)[axis]), 0x1p44 + 0x1p39 + 1);
  }
}

/// Is q the integer nearest to (x - origin) / unit, a tie going to the even one?
void expect_nearest(const World& world, double x, int axis, double q) {
  EXPECT_EQ(q, std::floor(q));
  EXPECT_FALSE(q == 0 && std::signbit(q));
  const Rational exact = (Rational(x) - Rational(world.frame().origin[axis])) / Rational(world.unit());
  const Rational error = abs(Rational(q) - exact), half(1, 2);
  EXPECT_LE(error, half);
  EXPECT_TRUE(error != half || std::fmod(q, 2) == 0) << q;
}

/// x where the nearest integer is hard to tell: the double next to a half-integer, and its neighbours.
double near_tie(const World& world, int axis, Random& random) {
  const std::int64_t bound = std::int64_t{1} << random.integer(0, 48);
  const Rational half(2 * random.integer(-bound, bound - 1) + 1, 2);
  const Rational x = Rational(world.frame().origin[axis]) + Rational(world.unit()) * half;
  const double rounded = x.convert_to<double>();
  const double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(rounded, infinity * double(random.integer(0, 1) * 2 - 1));
}

void expect_rounding(const World& world, const Box3& box, Random& random) {
  for (int i = 0; i < 6; ++i) {
    Vec3 x{random.real(box.lo.x, box.hi.x), random.real(box.lo.y, box.hi.y), random.real(box.lo.z, box.hi.z)};
    if (i % 2 == 0) x = {near_tie(world, 0, random), near_tie(world, 1, random), near_tie(world, 2, random)};
    const Vec3 q = world.to_world(x);
    for (const int axis : {0, 1, 2}) expect_nearest(world, x[axis], axis, q[axis]);
  }
}

/// Some usable BCC level has a covering radius in (tightness, 1] * fit_radius.
void expect_fit(const World& world, double fit_radius, double tightness) {
  double best = 0;
  for (Level level = 2; level <= kMaxLevel; level += 2) {
    const double r = covering_radius(level) * world.unit();
    if (level > world.finest_level() && r <= fit_radius) best = std::max(best, r);
  }
  EXPECT_GT(best, tightness * fit_radius);
}

/// Offsets are multiples of the extent: 2^21 leaves any m its 7 bits, 2^27 some m, 2^31 leaves m = 64.
void check_fit(double extent, double offset_ratio, double fit_ratio, Random& random) {
  const double offset = extent * offset_ratio;
  const auto jitter = [&] { return random.real(-1, 1) * offset; };
  const Vec3 center{offset, jitter(), jitter()};
  const Box3 box = box_at(center, {extent * random.real(0.1, 1), extent, extent * random.real(0, 1)});
  const double fit_radius = fit_ratio * box.longest_side();
  SCOPED_TRACE(testing::Message() << "box " << box.lo << " to " << box.hi << " fit " << fit_radius);
  const World world = World::fit(box, fit_radius);
  expect_form(world, box);
  expect_exact_lattice(world, random);
  expect_rounding(world, box, random);
  if (fit_ratio > 0) expect_fit(world, fit_radius, std::abs(offset_ratio) <= 0x1p21 ? 64.0 / 65 : 0.5);
}

TEST(World, FitsWhatItPromisesAtAnyScaleAndOffset) {
  Random random(41);
  for (const double extent : {1e-289, 1e-200, 1e-10, 1e-3, 1.0, 64.0, 1e6, 1e100}) {
    for (const double ratio : {0.0, 0.5, -1.0, 3.7, -1e3, 1e6, 0x1p21, -0x1p24, 0x1p27, 0x1p30}) {
      for (const double fit : {0.0, 1.5, 0.1, 0.0123, 1e-4}) check_fit(extent, ratio, fit, random);
    }
  }
  for (const double ratio : {0.0, 0.5, -0.4}) check_fit(1e300, ratio, 0.03, random);
}

TEST(World, FitsRandomJobs) {
  Random random(42);
  const int jobs = std::getenv("UNSLIVER_LONG") ? 200'000 : 2'000;
  for (int i = 0; i < jobs; ++i) {
    const double extent = std::ldexp(random.real(0.5, 1), int(random.integer(-900, 900)));
    const double ratio = random.real(-1, 1) * std::ldexp(1.0, int(random.integer(-10, 21)));
    check_fit(extent, ratio, std::ldexp(random.real(0.5, 1), int(random.integer(-19, 2))), random);
  }
}

TEST(World, RoundsTiesToEvenAndTellsWhatIsNextToThem) {
  Random random(44);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double unit : {64.0, 96.0, 127.0, 101 * 0x1p-60, 77 * 0x1p-990, 113 * 0x1p900}) {
    for (const double shift : {0.0, 0x1p40, -3 * 0x1p47, 5 * 0x1p60}) {
      const World world(Frame{unit, {shift * unit, -shift * unit, 0}});
      for (int i = 0; i < 200; ++i) {
        const std::int64_t bound = std::int64_t{1} << random.integer(0, 48);
        const double half = double(random.integer(-bound, bound - 1)) + 0.5;
        const double tie = world.frame().origin.x + unit * half;  // to rounding
        for (const double x : {tie, std::nextafter(tie, infinity), std::nextafter(tie, -infinity)})
          expect_nearest(world, x, 0, world.to_world({x, 0, 0}).x);
      }
    }
  }
  const World standard{Frame{}};
  for (const double q : {0.5, 1.5, -0.5, -1.5, 2.5, 0x1p47 - 0.5, 0x1p47 + 0.5})
    EXPECT_EQ(standard.to_world({q, 0, 0}).x, std::nearbyint(q)) << q;
}

/// Digits of x far below the last place of x - origin decide.
TEST(World, NoDigitIsTooSmallToBreakATie) {
  const World world(Frame{2, {6, 2, 0}});
  EXPECT_EQ(world.to_world({1, 1, 1}), (Vec3{-2, 0, 0}));  // -2.5, -0.5 and 0.5
  EXPECT_EQ(world.to_world({std::nextafter(1, 0), std::nextafter(1, 0), std::nextafter(1, 2)}),
            (Vec3{-3, -1, 1}));
  const World far(Frame{2, {0x1p48, 0x1p48, -0x1p48}});
  EXPECT_EQ(far.to_world({1, std::nextafter(1, 2), 1}), (Vec3{-0x1p47, 1 - 0x1p47, 0x1p47}));
  EXPECT_EQ(far.to_world({-1, -1, std::nextafter(1, 2)}), (Vec3{-0x1p47, -0x1p47, 0x1p47 + 1}));
  const World tiny(Frame{127, {0, 0, 0}});
  EXPECT_EQ(tiny.to_world({63.5, 190.5, -63.5}), (Vec3{0, 2, 0}));
  EXPECT_EQ(tiny.to_world({std::nextafter(63.5, 64), std::nextafter(190.5, 0), std::nextafter(-63.5, -64)}),
            (Vec3{1, 1, -1}));
}

TEST(World, CoordinatesBeyondTheWorldStayBeyondIt) {
  const double infinity = std::numeric_limits<double>::infinity();
  const World world(Frame{0x1p-44, {1, 1, 1}});
  for (const double x : {20.0, -20.0, 1e200, -1.7e308, infinity, -infinity})
    EXPECT_GE(std::abs(world.to_world({x, 0, 0}).x), 0x1p48) << x;
  EXPECT_TRUE(std::isnan(world.to_world({std::nan(""), 0, 0}).x));
}

TEST(World, FitDecidesTheLastDigit) {
  for (int m = 64; m < 128; ++m) {
    const double radius = 0x1p-10 * m * covering_radius(0), below = std::nextafter(radius, 0);
    const Box3 box = box_at({0, 0, 0}, {1, 1, 1});
    int e = 0;
    EXPECT_EQ(128 * std::frexp(World::fit(box, radius).unit(), &e), m);
    EXPECT_EQ(128 * std::frexp(World::fit(box, below).unit(), &e), m == 64 ? 127 : m - 1);
  }
}

TEST(World, UsesEveryIntegerNearTheOriginAndGivesUpNoMoreThanItMust) {
  const Box3 unit_box = box_at({0.5, 0.5, 0.5}, {1, 1, 1});
  const World plain = World::fit(unit_box, 0);
  EXPECT_EQ(plain.finest_level(), 1);
  EXPECT_EQ(plain.unit(), 0x1p-44);
  EXPECT_EQ(plain.frame().origin, (Vec3{0.5, 0.5, 0.5}));
  // m = 127 takes seven bits: 2^48 * 127 needs two zeros, and one is not enough.
  const World odd = World(Frame{127, {0, 0, 0}});
  EXPECT_EQ(odd.finest_level(), 5);
  const Rational finer = Rational(0x1p48 - 2) * 127;
  EXPECT_NE(Rational(finer.convert_to<double>()), finer);
  EXPECT_EQ(World(Frame{31 * 4, {0, 0, 0}}).finest_level(), 1);
  EXPECT_EQ(World(Frame{33 * 2, {0, 0, 0}}).finest_level(), 3);
  EXPECT_EQ(World(Frame{64, {-64 * (0x1p53 - 0x1p48), 0, 0}}).finest_level(), 1);
  EXPECT_EQ(World(Frame{64, {-64 * 0x1p53, 0, 0}}).finest_level(), 3);
}

TEST(World, AFrameGivesTheSameWorld) {
  Random random(43);
  for (const double offset : {0.0, 1e3, -1e7}) {
    const World fitted = World::fit(box_at({offset, -offset, 1}, {2, 3, 1}), 0.07);
    const World again(fitted.frame());
    EXPECT_EQ(again.finest_level(), fitted.finest_level());
    EXPECT_EQ(again.frame().origin, fitted.frame().origin);
    expect_exact_lattice(again, random);
  }
  const World standard{Frame{}};
  EXPECT_EQ(standard.finest_level(), 1);
  EXPECT_EQ(standard.to_caller({-3, 2, 1}), (Vec3{-3, 2, 1}));
}

TEST(World, FitsTheStepThatCloseInputsNeed) {
  const Box3 near = box_at({0, 0, 0}, {1, 1, 1}), far = box_at({1000, 0, 0}, {1, 1, 1});
  const double fit = 127 * covering_radius(2) * 0x1p-20;  // asks for m = 127, whose finest level is 5
  EXPECT_EQ(World::fit(near, fit).finest_level(), 5);
  for (const double max_step : {1e-12, 0x1p-43, 0x1p-44}) {
    const World world = World::fit(near, fit, max_step);
    EXPECT_LE(power_of_two(world.finest_level() / 2) * world.unit(), max_step);
    expect_fit(world, fit, 0.5);
  }
  EXPECT_THROW((void)World::fit(near, fit, 0x1p-46), Error);
  EXPECT_NO_THROW((void)World::fit(far, fit, 1e-11));
  EXPECT_THROW((void)World::fit(far, fit, 1e-14), Error);
}

TEST(World, RefusesBoxesThatCannotBeMeshed) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_of(Box3{}, 1), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(Box3{{0, 0, 0}, {1, 1, infinity}}, 1), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(Box3{{0, std::nan(""), 0}, {1, 1, 1}}, 1), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(Box3{{0, 0, 0}, {1, -1, 1}}, 1), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(Box3{{3, 4, 5}, {3, 4, 5}}, 1), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(box_at({0, 0, 0}, {1e-291, 0, 0}), 0), ErrorCode::kLimit);
  EXPECT_EQ(code_of(Box3{{-1.7e308, 0, 0}, {1.7e308, 1, 1}}, 0), ErrorCode::kLimit);
  EXPECT_EQ(code_of(box_at({0, 2e300, 0}, {1e299, 1e299, 1e299}), 0), ErrorCode::kLimit);
  EXPECT_EQ(code_of(box_at({0, 0, 1e290}, {1e-280, 0, 0}), 0), ErrorCode::kLimit);
}

TEST(World, RefusesOffsetsThatLeaveTooFewSteps) {
  EXPECT_EQ(code_of(box_at({1e12, 0, 0}, {1e-3, 1e-3, 1e-3}), 0), ErrorCode::kLimit);
  for (const double offset : {0x1p31, 0x1p33, 0x1p34, 0x1p40, 0x1p60}) {
    const Box3 box = box_at({0, -offset, 0}, {1, 1, 1});
    const bool too_far = offset > 0x1p32;
    EXPECT_EQ(code_of(box, 0), too_far ? ErrorCode::kLimit : ErrorCode::kInternal) << offset;
  }
  try {
    (void)World::fit(box_at({1e12, 0, 0}, {1, 1, 1}), 0);
    FAIL() << "12 digits before the point leave too few behind it";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("closer to the origin"), std::string::npos) << error.what();
    EXPECT_EQ(error.places.size(), 2U);
  }
}

TEST(World, RefusesSizesBelowTheFinestLattice) {
  const Box3 near = box_at({0, 0, 0}, {1, 1, 1}), far = box_at({1e9, 0, 0}, {1, 1, 1});
  EXPECT_EQ(code_of(near, 1e-12), ErrorCode::kInternal);
  EXPECT_EQ(code_of(near, 1e-14), ErrorCode::kLimit);
  EXPECT_EQ(code_of(near, 5e-324), ErrorCode::kLimit);
  EXPECT_EQ(code_of(far, 1e-3), ErrorCode::kInternal);
  EXPECT_EQ(code_of(far, 1e-8), ErrorCode::kLimit);
}

TEST(World, NothingToFitOrFarTooLarge) {
  const Box3 box = box_at({0, 0, 0}, {1, 1, 1});
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double none : {0.0, -1.0, 4.001, 1.7e308, infinity, std::nan("")}) {
    EXPECT_EQ(World::fit(box, none).unit(), 0x1p-44) << none;
  }
  EXPECT_NE(World::fit(box, 3.9).unit(), 0x1p-44);
}

TEST(World, RefusesFramesThatAreNotOurs) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Frame bad[] = {
      {0, {0, 0, 0}},
      {-64, {0, 0, 0}},
      {infinity, {0, 0, 0}},
      {std::nan(""), {0, 0, 0}},
      {0x1p-1030, {0, 0, 0}},
      {0x1p1000, {0, 0, 0}},  // the end of the world overflows
      {0.1, {0, 0, 0}},       // m is not an integer
      {1, {0, 0.5, 0}},       // the origin is no multiple of the unit
      {1, {0, 0, infinity}},
      {1, {0, 0, std::nan("")}},
      {127, {127, 0, 0}},  // ... nor of the finest lattice of exact doubles
      {1, {1, 0x1p60, 0}},
      {1, {0x1p200, 0, 0}},  // no level is coarse enough
      {0x1p-500, {0x1p1000, 0, 0}},
  };
  for (const Frame& frame : bad) {
    try {
      const World world(frame);
      FAIL() << "unit " << frame.unit << " origin " << frame.origin;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    }
  }
}

}  // namespace
}  // namespace unsliver::lattice
