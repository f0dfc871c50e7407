#include <gtest/gtest.h>

#include "domain/sample_surfaces.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

using samples::Dice;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A sampled inner point in the domain obliges meets; the ball of clearance is on one side.
void expect_sound(const Domain& domain, const Vec3& center, double reach, std::uint64_t seed) {
  SCOPED_TRACE(seed);
  Dice dice(seed);
  int met = 0, clear = 0;
  for (int n = 0; n < 1000; ++n) {
    SCOPED_TRACE(n);
    const Vec3 at = dice.around(center, reach);
    const Tet t = dice.tet_around(at, reach * (n % 2 ? 0.1 : 1.5));
    bool holds = false;
    for (int i = 0; i < 100; ++i) holds = holds || domain.contains(dice.inside(t));
    const bool meets = domain.meets(t);
    EXPECT_TRUE(meets || !holds);
    met += meets;
    const double c = domain.clearance(at);
    clear += c != 0;
    for (int i = 0; i < 20; ++i) {
      const bool inside = domain.contains(dice.in_ball(at, std::abs(c)));
      EXPECT_TRUE(c == 0 || inside == (c < 0)) << c;
    }
    EXPECT_TRUE(!domain.contains(at) || domain.bounds().contains(at));
  }
  EXPECT_GT(met, 50);
  EXPECT_LT(met, 950);
  EXPECT_GT(clear, 900);
}

TEST(BoxDomain, IsSound) {
  expect_sound(*make_box({{0, 0, 0}, {1, 2, 3}}), {0.5, 1, 1.5}, 3, 1);
  expect_sound(*make_box({{1e8, -1e8, 5e7}, {1e8 + 1, -1e8 + 2, 5e7 + 3}}), {1e8 + 0.5, -1e8 + 1, 5e7 + 1.5},
               3, 2);
}

TEST(BallDomain, IsSound) {
  expect_sound(*make_ball({1, 2, 3}, 1.5), {1, 2, 3}, 3, 3);
  expect_sound(*make_ball({1e8, 2, -1e9}, 1.5), {1e8, 2, -1e9}, 3, 4);
}

/// Clearance of both is the distance itself.
TEST(BoxDomain, ClearanceIsTight) {
  const DomainPtr box = make_box({{0, 0, 0}, {1, 1, 1}});
  EXPECT_NEAR(box->clearance({0.5, 0.5, 0.25}), -0.25, 1e-14);
  EXPECT_NEAR(box->clearance({2, 0.5, 0.5}), 1, 1e-14);
  EXPECT_NEAR(box->clearance({2, 2, 2}), std::sqrt(3.0), 1e-14);
  EXPECT_EQ(box->clearance({1, 0.5, 0.5}), 0);
}

TEST(BallDomain, ClearanceIsTight) {
  const DomainPtr ball = make_ball({0, 0, 0}, 2);
  EXPECT_NEAR(ball->clearance({0, 0, 0}), -2, 1e-13);
  EXPECT_NEAR(ball->clearance({0, 3, 4}), 3, 1e-13);
  EXPECT_EQ(ball->clearance({0, 0, 2}), 0);
}

/// The tetrahedra of a lattice that share a face, an edge or a corner with the box lie outside it.
TEST(BoxDomain, TouchingTetrahedraAreOutside) {
  const DomainPtr box = make_box({{0, 0, 0}, {1, 1, 1}});
  const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_FALSE(box->meets({{x, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}}));        // face in the plane x = 1
  EXPECT_FALSE(box->meets({{{0.5, 0.5, 1}, z, {1, 0, 1}, {0.5, 0, 2}}}));  // face in the plane z = 1
  EXPECT_FALSE(box->meets({{o, z, {-1, 0, 0}, {0, -1, 0}}}));              // an edge of the box
  EXPECT_FALSE(box->meets({{o, z, {1, -1, 0}, {-1, 1, -3}}}) &&
               box->meets({{o, z, {-1, 1, -3}, {1, -1, 0}}}));  // its plane x + y = 0 touches the edge
  EXPECT_FALSE(box->meets({{o, {-1, -1, 0}, {-1, 0, -1}, {0, -1, -1}}}));  // a corner
  EXPECT_FALSE(
      box->meets({{{-1, 0.5, 1}, {1, 0.5, 3}, {0, -1, 5}, {0, 2, 5}}}));  // edge across an edge, beyond
  EXPECT_TRUE(box->meets({{{0.999, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}}));
  EXPECT_TRUE(box->meets({{o, x, y, z}}));                                              // in a corner
  EXPECT_TRUE(box->meets({{{-9, -9, -9}, {30, -9, -9}, {-9, 30, -9}, {-9, -9, 30}}}));  // around it
  EXPECT_TRUE(box->meets({{{-1, -0.5, 0.5}, {0.01, 0.01, 0.4}, {-1, 0.5, 0.5}, {-1, 0, 2}}}));
}

/// Exactly one unit in the last place decides, far from the origin too.
TEST(BoxDomain, OneUnitInTheLastPlaceDecides) {
  for (const double offset : {0.0, 1e6, -12345678.0}) {
    const DomainPtr box = make_box({{offset, 0, 0}, {offset + 1, 1, 1}});
    const double face = offset + 1, inner = std::nextafter(face, -kInfinity);
    const auto tet_from = [&](double from) {
      return Tet{{{from, 0.2, 0.2}, {offset + 3, 0.2, 0.2}, {offset + 3, 0.8, 0.2}, {offset + 3, 0.2, 0.8}}};
    };
    EXPECT_FALSE(box->meets(tet_from(face)));
    EXPECT_TRUE(box->meets(tet_from(inner)));
  }
}

/// All tetrahedra of a Kuhn subdivision of a grid: those kept are those of the cubes inside, no more.
TEST(BoxDomain, KeepsExactlyTheCubesInside) {
  const DomainPtr box = make_box({{0, 0, 0}, {2, 1, 1}});
  constexpr int kPaths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  int kept = 0;
  for (int cube = 0; cube < 125; ++cube)
    for (const auto& path : kPaths) {
      Tet t;
      Vec3 p{cube % 5 - 1.0, cube / 5 % 5 - 1.0, cube / 25 - 1.0};
      for (std::size_t i = 0; i < 4; ++i) {
        t[i] = p;
        if (i < 3) p[path[i]] += 1;
      }
      kept += box->meets(t);
    }
  EXPECT_EQ(kept, 2 * 6);
}

TEST(BallDomain, FarAndTouchingTetrahedra) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  EXPECT_FALSE(ball->meets({{{1.001, -5, -5}, {1.001, 9, -5}, {1.001, -5, 9}, {3, 0, 0}}}));
  EXPECT_TRUE(ball->meets({{{0.999, -5, -5}, {0.999, 9, -5}, {0.999, -5, 9}, {3, 0, 0}}}));
  EXPECT_TRUE(ball->meets({{{-9, -9, -9}, {30, -9, -9}, {-9, 30, -9}, {-9, -9, 30}}}));
  EXPECT_NEAR(ball->volume(), 4.18879, 1e-5);
}

TEST(Domain, BadInputIsRefused) {
  const auto code_of = [](auto make) {
    try {
      make();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()), "");
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  const auto bad_box = [&](const Box3& box) { return code_of([&] { make_box(box); }); };
  EXPECT_EQ(bad_box({{0, 0, 0}, {1, 0, 1}}), ErrorCode::kBadInput);
  EXPECT_EQ(bad_box({{0, 0, 0}, {1, -1, 1}}), ErrorCode::kBadInput);
  EXPECT_EQ(bad_box({{0, 0, 0}, {1, kNan, 1}}), ErrorCode::kBadInput);
  EXPECT_EQ(bad_box({{0, 0, 0}, {1, kInfinity, 1}}), ErrorCode::kBadInput);
  EXPECT_EQ(bad_box({{0, 0, 0}, {1, 1e200, 1}}), ErrorCode::kBadInput);
  EXPECT_EQ(bad_box({}), ErrorCode::kBadInput);
  const auto bad_ball = [&](const Vec3& c, double r) { return code_of([&] { make_ball(c, r); }); };
  EXPECT_EQ(bad_ball({0, 0, 0}, 0), ErrorCode::kBadInput);
  EXPECT_EQ(bad_ball({0, 0, 0}, -1), ErrorCode::kBadInput);
  EXPECT_EQ(bad_ball({0, 0, 0}, kNan), ErrorCode::kBadInput);
  EXPECT_EQ(bad_ball({kNan, 0, 0}, 1), ErrorCode::kBadInput);
  EXPECT_EQ(bad_ball({0, 0, 0}, kInfinity), ErrorCode::kBadInput);
}

TEST(Domain, DescribesItself) {
  EXPECT_EQ(make_ball({0, 0, 0}, 1)->describe(), "ball, centre (0, 0, 0), radius 1");
  EXPECT_EQ(make_box({{0, 0, 0}, {1, 2, 0.1}})->describe(), "box, (0, 0, 0) to (1, 2, 0.1)");
}

}  // namespace
}  // namespace unsliver
