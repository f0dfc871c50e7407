#include <gtest/gtest.h>

#include <functional>

#include "domain/sample_surfaces.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

using samples::box_surface;
using samples::Dice;
using samples::joined;
using samples::sphere_surface;

/// `inside` is the truth, away from the surface by more than `fuzz`.
struct Case {
  std::string name;
  TriangleMesh surface;
  std::function<bool(const Vec3&)> inside;
};

bool in_box(const Vec3& p, double lo, double hi) {
  return lo < std::min({p.x, p.y, p.z}) && std::max({p.x, p.y, p.z}) < hi;
}

/// A rotation about (1, 1, 1) by an angle that fits no lattice, and its inverse.
Vec3 turned(const Vec3& p, double angle) {
  const Vec3 k = (1 / std::sqrt(3.0)) * Vec3{1, 1, 1};
  return std::cos(angle) * p + std::sin(angle) * cross(k, p) + ((1 - std::cos(angle)) * dot(k, p)) * k;
}

TriangleMesh turned(TriangleMesh m, double angle) {
  for (Vec3& p : m.points) p = turned(p, angle);
  return m;
}

std::vector<Case> closed_cases() {
  const TriangleMesh big = box_surface({{0, 0, 0}, {3, 3, 3}}, 3),
                     small = box_surface({{1, 1, 1}, {2, 2, 2}}, 2);
  const Vec3 far{1e7, -2e7, 3e6};
  return {
      {"box", big, [](const Vec3& p) { return in_box(p, 0, 3); }},
      {"box inside out", samples::inside_out(big), [](const Vec3& p) { return in_box(p, 0, 3); }},
      {"box with a cavity", joined(big, samples::inside_out(small)),
       [](const Vec3& p) { return in_box(p, 0, 3) && !in_box(p, 1, 2); }},
      {"nested boxes", joined(big, small), [](const Vec3& p) { return in_box(p, 0, 3); }},
      {"overlapping boxes", joined(big, box_surface({{1.5, 1.5, 1.5}, {4, 4, 4}})),
       [](const Vec3& p) { return in_box(p, 0, 3) || in_box(p, 1.5, 4); }},
      {"boxes that share an edge",
       joined(box_surface({{0, 0, 0}, {1, 1, 1}}), box_surface({{1, 1, 0}, {2, 2, 1}})),
       [](const Vec3& p) {
         return 0 < p.z && p.z < 1 &&
                (in_box({p.x, p.y, 0.5}, 0, 1) || in_box({p.x - 1, p.y - 1, 0.5}, 0, 1));
       }},
      {"turned box", turned(big, 0.3), [](const Vec3& p) { return in_box(turned(p, -0.3), 0, 3); }},
      {"box far away", box_surface({far, far + Vec3{3, 3, 3}}, 3),
       [far](const Vec3& p) { return in_box(p - far, 0, 3); }},
  };
}

double reach_of(const Domain& domain) { return 0.6 * domain.bounds().longest_side(); }

TEST(SurfaceDomain, ContainsWhatItBounds) {
  for (const Case& c : closed_cases()) {
    SCOPED_TRACE(c.name);
    const DomainPtr domain = make_surface(c.surface);
    Dice dice(1);
    for (int n = 0; n < 3000; ++n) {
      const Vec3 p = dice.around(domain->bounds().center(), reach_of(*domain));
      EXPECT_EQ(domain->contains(p), c.inside(p)) << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST(SurfaceDomain, ClearanceBallsAreOnOneSide) {
  for (const Case& c : closed_cases()) {
    SCOPED_TRACE(c.name);
    const DomainPtr domain = make_surface(c.surface);
    Dice dice(2);
    int clear = 0;
    for (int n = 0; n < 1500; ++n) {
      const Vec3 p = n % 2 ? dice.around(domain->bounds().center(), (n % 4 ? 1 : 5) * reach_of(*domain))
                           : dice.around(dice.on(c.surface, dice.below(c.surface.triangles.size())), 0.05);
      const double radius = domain->clearance(p);
      clear += radius != 0;
      for (int i = 0; i < 20 && radius != 0; ++i)
        EXPECT_EQ(c.inside(dice.in_ball(p, std::abs(radius))), radius < 0) << n;
    }
    EXPECT_GT(clear, 1450);
  }
}

TEST(SurfaceDomain, MeetsWhereASampleIsInside) {
  for (const Case& c : closed_cases()) {
    SCOPED_TRACE(c.name);
    const DomainPtr domain = make_surface(c.surface);
    Dice dice(3);
    int met = 0;
    for (int n = 0; n < 1500; ++n) {
      SCOPED_TRACE(n);
      const Tet t =
          dice.tet_around(dice.around(domain->bounds().center(), 1.2 * reach_of(*domain)), n % 2 ? 0.15 : 1);
      bool holds = false;
      for (int i = 0; i < 60; ++i) holds = holds || c.inside(dice.inside(t));
      const bool meets = domain->meets(t);
      EXPECT_TRUE(meets || !holds);
      met += meets;
    }
    EXPECT_GT(met, 100);
    EXPECT_LT(met, 1400);
  }
}

/// Two independent and exact ways to the same answer, neither of which wastes.
TEST(SurfaceDomain, ABoxSurfaceMeetsWhatTheBoxMeets) {
  const DomainPtr box = make_box({{0, 0, 0}, {3, 3, 3}});
  const DomainPtr surface = make_surface(box_surface({{0, 0, 0}, {3, 3, 3}}, 3));
  const DomainPtr turned_surface = make_surface(turned(box_surface({{0, 0, 0}, {3, 3, 3}}, 3), 0.3));
  Dice dice(9);
  int met = 0;
  for (int n = 0; n < 5000; ++n) {
    SCOPED_TRACE(n);
    Tet t = dice.tet_around(dice.around({1.5, 1.5, 1.5}, 2.5), n % 2 ? 0.2 : 1.5);
    if (n % 3 == 0)  // on a lattice, so that much touches
      for (Vec3& p : t) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
    if (dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) == 0) continue;
    const bool expected = box->meets(t);
    met += expected;
    EXPECT_EQ(surface->meets(t), expected);
    if (n % 3 == 0) continue;
    for (Vec3& p : t) p = turned(p, 0.3);
    EXPECT_EQ(turned_surface->meets(t), expected);
  }
  EXPECT_GT(met, 1000);
  EXPECT_LT(met, 4000);
}

/// Every triangle's surroundings are kept, on soups as well.
void expect_surface_covered(const TriangleMesh& surface, std::uint64_t seed) {
  SCOPED_TRACE(seed);
  const DomainPtr domain = make_surface(surface);
  Dice dice(seed);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = dice.on(surface, dice.below(surface.triangles.size()));
    const double size = n % 2 ? 1e-3 : 0.5;
    Tet t = dice.tet_around(p, size);
    const Vec3 shift = p - dice.inside(t);
    for (Vec3& corner : t) corner = corner + shift;  // p is inside t, up to rounding
    if (std::abs(dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0]))) < 1e-3 * size * size * size) continue;
    EXPECT_TRUE(domain->meets(t)) << n;
  }
}

TEST(SurfaceDomain, CoversItsTriangles) {
  for (const Case& c : closed_cases()) {
    SCOPED_TRACE(c.name);
    expect_surface_covered(c.surface, 4);
  }
}

TriangleMesh cup(int open_squares) {
  TriangleMesh m = box_surface({{0, 0, 0}, {3, 3, 3}}, 6);
  m.triangles.resize(m.triangles.size() - 2 * static_cast<std::size_t>(open_squares));  // at z = 3
  return m;
}

TEST(SurfaceDomain, OpenSurfacesAreFilledAndCovered) {
  const TriangleMesh m = cup(9);
  expect_surface_covered(m, 5);
  const DomainPtr domain = make_surface(m);
  EXPECT_TRUE(domain->contains({1, 1, 1}));
  EXPECT_FALSE(domain->contains({1, 1, 3.1}));
  EXPECT_FALSE(domain->contains({-0.1, 1, 1}));
  ASSERT_EQ(domain->notes().size(), 1u);
  EXPECT_NE(domain->notes()[0].find("open"), std::string::npos) << domain->notes()[0];
  EXPECT_NEAR(domain->volume(), 27, 4);
}

/// Against the winding number itself (which contains() follows), also where no triangle is near: across the
/// opening.
TEST(SurfaceDomain, OpenSurfacesAreSound) {
  for (const int squares : {2, 36}) {
    const TriangleMesh m = cup(squares);
    const DomainPtr domain = make_surface(m);
    Dice dice(6);
    int met = 0, clear = 0;
    for (int n = 0; n < 2000; ++n) {
      SCOPED_TRACE(n);
      const Vec3 p = n % 2 ? dice.around({1.5, 1.5, 1.5}, 2) : dice.around({1.5, 1.5, 2.8}, 1);
      const Tet t = dice.tet_around(p, n % 3 ? 0.1 : 0.5);
      bool holds = false;
      for (int i = 0; i < 60; ++i) holds = holds || domain->contains(dice.inside(t));
      const bool meets = domain->meets(t);
      EXPECT_TRUE(meets || !holds);
      met += meets;
      const double radius = domain->clearance(p);
      clear += radius != 0;
      for (int i = 0; i < 20 && radius != 0; ++i)
        EXPECT_EQ(domain->contains(dice.in_ball(p, std::abs(radius))), radius < 0);
    }
    EXPECT_GT(met, 600);
    EXPECT_LT(met, 1800);
    EXPECT_GT(clear, 1500);
  }
}

/// A sheet encloses nothing; the tetrahedra that touch it are kept, those at a distance are not.
TEST(SurfaceDomain, ASheetIsKeptAsASheet) {
  const TriangleMesh m{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.25}}, {{0, 1, 2}, {1, 3, 2}}, "sheet"};
  expect_surface_covered(m, 7);
  const DomainPtr domain = make_surface(m);
  EXPECT_TRUE(domain->meets({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));  // touches with a face
  EXPECT_FALSE(domain->meets({{{0, 0, 0.3}, {1, 0, 0.3}, {0, 1, 0.3}, {0, 0, 1}}}));
  EXPECT_FALSE(domain->meets({{{0, 0, -0.1}, {0, 1, -0.1}, {1, 0, -0.1}, {0, 0, -1}}}));
}

/// Lattice planes in the surface: what only touches from outside is not kept.
TEST(SurfaceDomain, CleanSurfacesKeepExactlyTheCubesInside) {
  for (const double scale : {1.0, 0.1, 1.0 / 3}) {
    const DomainPtr domain = make_surface(box_surface({{0, 0, 0}, {2 * scale, 2 * scale, 2 * scale}}, 2));
    constexpr int kPaths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    int kept = 0;
    for (int cube = 0; cube < 64; ++cube)
      for (const auto& path : kPaths) {
        Tet t;
        Vec3 p{cube % 4 - 1.0, cube / 4 % 4 - 1.0, cube / 16 - 1.0};
        for (std::size_t i = 0; i < 4; ++i) {
          t[i] = {2 * scale * p.x / 2, 2 * scale * p.y / 2, 2 * scale * p.z / 2};
          if (i < 3) p[path[i]] += 1;
        }
        kept += domain->meets(t);
      }
    EXPECT_EQ(kept, 8 * 6) << scale;
  }
}

TEST(SurfaceDomain, SphereHasItsVolumeAndNoNotes) {
  const DomainPtr domain = make_surface(sphere_surface({1, 2, 3}, 2, 24));
  EXPECT_NEAR(domain->volume(), 8 * 4.18879, 0.2);
  EXPECT_TRUE(domain->notes().empty());
  EXPECT_LT(domain->clearance({1, 2, 3}), -0.6);  // at least a third of the distance
  EXPECT_GT(domain->clearance({1, 2, 13}), 5);
}

TEST(SurfaceDomain, CountsItsTriangles) {
  TriangleMesh m;
  m.name = "flag.off";
  m.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  m.triangles = {{0, 1, 2}};
  EXPECT_EQ(make_surface(m)->describe(), "surface flag.off, 1 triangle, open");
  m.triangles.push_back({1, 3, 2});
  EXPECT_EQ(make_surface(m)->describe(), "surface flag.off, 2 triangles, open");
}

TEST(SurfaceDomain, IsDeterministic) {
  const TriangleMesh m = joined(cup(4), sphere_surface({1.5, 1.5, 3}, 0.7, 5));
  const DomainPtr a = make_surface(m), b = make_surface(m);
  Dice dice(8);
  for (int n = 0; n < 500; ++n) {
    const Vec3 p = dice.around({1.5, 1.5, 1.5}, 2);
    EXPECT_EQ(a->clearance(p), b->clearance(p));
  }
}

TEST(SurfaceDomain, BadInputIsRefused) {
  const auto code_of = [](const TriangleMesh& m) {
    try {
      make_surface(m);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  TriangleMesh m = box_surface({{0, 0, 0}, {1, 1, 1}});
  m.points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of(m), ErrorCode::kBadInput);
  m.points[3].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_of(m), ErrorCode::kBadInput);
  m.points[3].y = 1e100;
  EXPECT_EQ(code_of(m), ErrorCode::kBadInput);
  EXPECT_EQ(code_of({}), ErrorCode::kBadInput);
  EXPECT_EQ(code_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, "no triangle"}), ErrorCode::kBadInput);
  EXPECT_EQ(code_of({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}, "collinear"}), ErrorCode::kBadInput);
  EXPECT_EQ(code_of({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}, "a point"}), ErrorCode::kBadInput);
  EXPECT_EQ(code_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}, "index"}), ErrorCode::kBadInput);
}

}  // namespace
}  // namespace unsliver
