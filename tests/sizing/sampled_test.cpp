#include <limits>
#include <stdexcept>

#include "sizing/grid.hpp"
#include "sizing_properties.hpp"

namespace unsliver {
namespace {

using namespace test;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::numeric_limits<double>::quiet_NaN();
const Box3 kBox{{-1, 0, 2}, {1, 3, 2.5}};
const Box3 kAround{{-2, -1, 1}, {2, 4, 4}};

TEST(SampledSize, ReproducesTrilinearFunctions) {
  const auto f = [](const Vec3& p) { return 10 + p.x - 0.5 * p.y * p.z + 0.25 * p.x * p.y; };
  const SizingPtr s = sampled_size(f, kBox, 5000);
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = random.in(kBox);
    ASSERT_NEAR(s->at(p), f(p), 1e-13);
  }
  EXPECT_NEAR(s->at({-5, 1, 2.25}), f({-1, 1, 2.25}), 1e-13) << "outside: the nearest point inside";
}

TEST(SampledSize, IsSoundAndTight) {
  const auto wave = [](const Vec3& p) { return 0.3 + 0.1 * std::sin(9 * p.x) * std::cos(7 * p.y + p.z); };
  const auto jump = [](const Vec3& p) { return p.x + p.y < 1 ? 0.1 : 2.0; };
  for (const std::function<double(const Vec3&)>& f :
       {std::function<double(const Vec3&)>(wave), std::function<double(const Vec3&)>(jump)}) {
    for (std::size_t samples : {8u, 100u, 20000u}) {
      const SizingPtr s = sampled_size(f, kBox, samples);
      expect_sound(*s, kAround, 1000);
      expect_tight(*s, kAround, 2 * s->lipschitz());
    }
  }
}

TEST(SampledSize, SaysThatItWasSampled) {
  const SizingPtr s = sampled_size([](const Vec3&) { return 1.0; }, kBox, 1000);
  ASSERT_EQ(s->notes().size(), 1u);
  EXPECT_NE(s->notes()[0].find("sampled once on a grid"), std::string::npos);
  EXPECT_EQ(s->lipschitz(), 0);
}

TEST(SampledSize, InfinityCounts) {
  const SizingPtr s = sampled_size([](const Vec3& p) { return p.x < 0 ? 0.5 : kInf; }, kBox, 1000);
  EXPECT_GT(s->at({0.9, 1, 2.1}), 1e299);
  EXPECT_DOUBLE_EQ(s->at({-0.9, 1, 2.1}), 0.5);
  expect_sound(*s, kAround, 300);
}

TEST(SampledSize, NamesThePointOfAFault) {
  const auto at_corner = [](double bad) {
    return [bad](const Vec3& p) { return p == Vec3{-1, 0, 2} ? bad : 1.0; };
  };
  for (double bad : {kNan, 0.0, -3.0}) {
    const Error e = expect_error([&] { sampled_size(at_corner(bad), kBox, 100); }, ErrorCode::kBadInput,
                                 "The size at (-1, 0, 2) is");
    EXPECT_EQ(e.places.size(), 1u);
  }
  const auto thrower = [](const Vec3&) -> double { throw std::runtime_error("no data here"); };
  expect_error([&] { sampled_size(thrower, kBox, 100); }, ErrorCode::kBadInput,
               "threw an exception at (-1, 0, 2): no data here");
  const auto odd = [](const Vec3&) -> double { throw 7; };
  expect_error([&] { sampled_size(odd, kBox, 100); }, ErrorCode::kBadInput, "unknown type");
  const auto one = [](const Vec3&) { return 1.0; };
  expect_error([&] { sampled_size(one, kBox, 7); }, ErrorCode::kBadOption, "7 samples");
  expect_error([&] { sampled_size(one, Box3{}, 100); }, ErrorCode::kBadInput, "bounds");
  expect_error([&] { sampled_size({}, kBox, 100); }, ErrorCode::kBadInput, "empty");
}

TEST(SampledSize, AsksForAllValuesAtOnceAndGetsTheSame) {
  const auto f = [](const Vec3& p) { return 5 + p.x * p.y; };
  int calls = 0;
  const auto many = [&](const std::vector<Vec3>& points) {
    ++calls;
    std::vector<double> values;
    for (const Vec3& p : points) values.push_back(f(p));
    return values;
  };
  const SizingPtr at_once = sampled_size_at_once(many, kBox, 500), one_by_one = sampled_size(f, kBox, 500);
  EXPECT_EQ(calls, 1);
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.in(kAround);
    ASSERT_EQ(at_once->at(p), one_by_one->at(p));
  }
  const auto too_few = [](const std::vector<Vec3>& points) {
    return std::vector<double>(points.size() - 1, 1.0);
  };
  expect_error([&] { sampled_size_at_once(too_few, kBox, 8); }, ErrorCode::kBadInput, "7 values for 8");
}

TEST(GridShape, HasAboutTheNumberOfNodesAskedForInCubicCells) {
  for (std::size_t samples : {8u, 50u, 1000u, 30000u, 1000000u}) {
    for (const Box3& box : {kBox, Box3{{0, 0, 0}, {1, 1, 1}}, Box3{{0, 0, 0}, {100, 1, 1e-3}}}) {
      const auto shape = sizing::GridShape::about(box, samples);
      const double nodes = static_cast<double>(shape.node_count());
      EXPECT_LE(nodes, static_cast<double>(samples));
      EXPECT_GE(nodes, 0.2 * static_cast<double>(samples));
      EXPECT_EQ(shape.node(0, 0, 0), box.lo);
      EXPECT_EQ(shape.node(shape.counts[0] - 1, shape.counts[1] - 1, shape.counts[2] - 1), box.hi);
    }
  }
}

}  // namespace
}  // namespace unsliver
