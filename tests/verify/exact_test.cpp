// Signs against plain rational arithmetic written here, and the attained bounds of the guarantees.

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "bcc_mesh.hpp"
#include "verify/grid.hpp"
#include "verify/judge.hpp"
#include "verify/lattice_check.hpp"
#include "verify/orientation.hpp"

namespace unsliver {
namespace {

using namespace testing_verify;
using verifier::mp::cpp_rational;
using Q3 = std::array<cpp_rational, 3>;

Q3 rational(const Vec3& p) { return {cpp_rational(p.x), cpp_rational(p.y), cpp_rational(p.z)}; }
Q3 operator-(const Q3& a, const Q3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
cpp_rational dot(const Q3& a, const Q3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
cpp_rational det(const Q3& a, const Q3& b, const Q3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

int slow_orientation(const std::vector<Vec3>& p) {
  const Q3 o = rational(p[0]);
  return verifier::sign(det(rational(p[1]) - o, rational(p[2]) - o, rational(p[3]) - o));
}

/// The circumcentre by Cramer's rule, then two distances.
int slow_in_sphere(const std::vector<Vec3>& p) {
  std::array<Q3, 5> d;
  for (int i = 0; i < 5; ++i) d[i] = rational(p[i]) - rational(p[0]);
  const Q3 half{dot(d[1], d[1]) / 2, dot(d[2], d[2]) / 2, dot(d[3], d[3]) / 2};
  Q3 center;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<Q3, 3> rows{d[1], d[2], d[3]};
    for (int i = 0; i < 3; ++i) rows[i][axis] = half[i];
    center[axis] = det(rows[0], rows[1], rows[2]) / det(d[1], d[2], d[3]);
  }
  const Q3 to_e = d[4] - center;
  return verifier::sign(cpp_rational(dot(center, center) - dot(to_e, to_e)));
}

/// Signed cos^2 of the angle at edge kl, by projecting the other two corners along the edge.
cpp_rational slow_cos_sq(const std::vector<Vec3>& p, int k, int l, int i, int j) {
  const Q3 e = rational(p[l]) - rational(p[k]);
  const auto across = [&](int m) {
    const Q3 d = rational(p[m]) - rational(p[k]);
    const cpp_rational along = dot(d, e) / dot(e, e);
    return Q3{d[0] - along * e[0], d[1] - along * e[1], d[2] - along * e[2]};
  };
  const Q3 u = across(i), v = across(j);
  const cpp_rational c = dot(u, v);
  return c * abs(c) / (dot(u, u) * dot(v, v));
}

/// Signs of (bound violated) for 30 and 135 degrees: +1 violated, 0 attained, -1 fine.
std::pair<int, int> slow_angles(const std::vector<Vec3>& p) {
  int low = -1, high = -1;
  for (const auto& f : verifier::kFacePairs) {
    const cpp_rational c = slow_cos_sq(p, f.k, f.l, f.i, f.j);
    low = std::max(low, verifier::sign(cpp_rational(c - cpp_rational(3, 4))));
    high = std::max(high, verifier::sign(cpp_rational(cpp_rational(-1, 2) - c)));
  }
  return {low, high};
}

/// A few random points; `bits` sets how likely ties are, `shift` puts them on another scale.
std::vector<Vec3> random_points(std::mt19937_64& random, int n, int bits, int shift) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(double(random() >> (64 - bits)), shift);
    points.push_back(p);
  }
  return points;
}

struct Setting {
  int bits, shift;
  bool grid;  ///< false: an extra point keeps the positions from being integers
};

constexpr Setting kSettings[] = {{2, 0, true},    {3, 20, true},  {6, 0, true},     {12, -30, true},
                                 {20, 0, true},   {40, 0, true},  {53, 0, true},    {2, 0, false},
                                 {3, 600, false}, {6, 0, false},  {3, -500, false}, {40, -3, false},
                                 {2, -40, false}, {53, 0, false}, {53, 900, false}};

template <class Test>
void for_random_points(int n, Test&& test) {
  for (const Setting& s : kSettings) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      SCOPED_TRACE("bits " + std::to_string(s.bits) + " shift " + std::to_string(s.shift) + " seed " +
                   std::to_string(seed));
      std::mt19937_64 random(seed);
      std::vector<Vec3> p = random_points(random, n, s.bits, s.shift);
      if (!s.grid) p.push_back({0x1p1000, 0x1p-1000, 0});
      test(p);
    }
  }
}

TEST(Exact, OrientationAgreesWithRationals) {
  verifier::SignCounts counts;
  int flat = 0;
  for_random_points(4, [&](const std::vector<Vec3>& p) {
    const verifier::Sites sites(p);
    verifier::Judge judge(sites, {});
    const int truth = slow_orientation(p);
    flat += truth == 0;
    EXPECT_EQ(judge.candidate({0, 1, 2, 3}).orientation, truth);
    EXPECT_EQ(verifier::orientation_sign(p[0], p[1], p[2], p[3], counts), truth);
  });
  EXPECT_GT(flat, 50);
  EXPECT_GT(counts.exact, 0u);
  EXPECT_GT(counts.filtered, 0u);
}

TEST(Exact, InSphereAgreesWithRationals) {
  int ties = 0;
  std::uint64_t exact = 0;
  for_random_points(5, [&](const std::vector<Vec3>& p) {
    const verifier::Sites sites(p);
    verifier::Judge judge(sites, {});
    const auto candidate = judge.candidate({0, 1, 2, 3});
    if (candidate.orientation == 0) return;
    const int truth = slow_in_sphere(p);
    ties += truth == 0;
    EXPECT_EQ(judge.in_sphere(candidate, 4), truth);
    exact += judge.exact_decisions();
  });
  EXPECT_GT(ties, 20);
  EXPECT_GT(exact, 0u);
}

TEST(Exact, AnglesAgreeWithRationals) {
  int attained = 0;
  const verifier::Bounds bounds = verifier::make_bounds({30, 135, INFINITY});
  for_random_points(4, [&](const std::vector<Vec3>& p) {
    const verifier::Sites sites(p);
    verifier::Judge judge(sites, bounds);
    const auto candidate = judge.candidate({0, 1, 2, 3});
    if (candidate.orientation == 0) return;
    const auto [low, high] = slow_angles(p);
    attained += low == 0 || high == 0;
    const verifier::Verdict verdict = judge.quality(candidate);
    EXPECT_EQ(verdict.min_angle, low);
    EXPECT_EQ(verdict.max_angle, high);
  });
  EXPECT_GT(attained, 5);
}

/// The angle at the edge 0-1, along (1,1,1), is between (-1,0,1) and (-1,-1,2): 30 degrees, the others are
/// wider.
TetMesh exactly_30(double s) {
  return single_tet({{{0, 0, 0}, {s, s, s}, {-2 * s, 0, 2 * s}, {-s, -s, 2 * s}}});
}
/// The angle at the edge 0-1, along z, is between (1,0) and (-1,1): 135 degrees.
TetMesh exactly_135(double s) { return single_tet({{{0, 0, 0}, {0, 0, s}, {s, 0, 0}, {-s, s, 0}}}); }
/// Circumcentre (s/2, s, 0), radius s sqrt(5)/2, shortest edge s.
TetMesh exactly_half_root_5(double s) {
  return single_tet({{{0, 0, 0}, {s, 0, 0}, {0, 2 * s, 0}, {0, s, s}}});
}

/// Corner v moved by one unit along an axis.
TetMesh moved(TetMesh mesh, VertexId v, int axis, double by) {
  mesh.points[v][axis] += by;
  return mesh;
}

TEST(Exact, ThirtyDegreesAreAttainedNotViolated) {
  for (const double s : {1.0, 0x1p20, 0x1p45, 0x1p-300}) {
    for (const bool grid : {true, false}) {
      SCOPED_TRACE(s);
      TetMesh mesh = exactly_30(s);
      if (!grid) mesh.points.push_back({0x1p1000, 0x1p-1000, 0});
      const VerifyReport r = verify(mesh, guaranteed(30, 180, INFINITY));
      EXPECT_TRUE(r.ok) << text(r);
      EXPECT_EQ(r.min_dihedral_deg, 30);
    }
  }
  // Corner 3 towards (-1,1,0) narrows the angle.
  const double s = 0x1p40;
  EXPECT_FALSE(verify(moved(exactly_30(s), 3, 0, -1), guaranteed(30, 180, INFINITY)).ok);
  EXPECT_TRUE(verify(moved(exactly_30(s), 3, 0, 1), guaranteed(30, 180, INFINITY)).ok);
}

TEST(Exact, OneHundredAndThirtyFiveDegreesAreAttainedNotViolated) {
  for (const double s : {1.0, 0x1p20, 0x1p45, 0x1p-300}) {
    const VerifyReport r = verify(exactly_135(s), guaranteed(0, 135, INFINITY));
    EXPECT_TRUE(r.ok) << text(r);
    EXPECT_EQ(r.max_dihedral_deg, 135);
  }
  const double s = 0x1p40;
  EXPECT_FALSE(verify(moved(exactly_135(s), 3, 0, -1), guaranteed(0, 135, INFINITY)).ok);
  EXPECT_TRUE(verify(moved(exactly_135(s), 3, 0, 1), guaranteed(0, 135, INFINITY)).ok);
}

TEST(Exact, HalfRootFiveIsAttainedNotViolated) {
  for (const double s : {1.0, 0x1p20, 0x1p45, 0x1p-300}) {
    const VerifyReport r = verify(exactly_half_root_5(s), guaranteed(0, 180));
    EXPECT_TRUE(r.ok) << text(r);
    EXPECT_EQ(r.max_radius_edge, std::sqrt(5.0) / 2);
  }
  const double s = 0x1p40;
  EXPECT_FALSE(verify(moved(exactly_half_root_5(s), 1, 0, -1), guaranteed(0, 180)).ok);
  EXPECT_TRUE(verify(moved(exactly_half_root_5(s), 1, 0, 1), guaranteed(0, 180)).ok);
}

TEST(Exact, EveryRecognisedAngle) {
  // Edge 0-1 along an axis or along (1,1,1), corners 2 and 3 in directions u and v across it.
  struct Case {
    double deg;
    Vec3 edge, u, v;
  };
  const Vec3 z{0, 0, 1}, diagonal{1, 1, 1};
  for (const Case& c : {Case{30, diagonal, {1, -1, 0}, {2, -1, -1}}, Case{45, z, {1, 0, 0}, {1, 1, 0}},
                        Case{60, diagonal, {1, -1, 0}, {1, 0, -1}}, Case{90, z, {1, 0, 0}, {0, 1, 0}},
                        Case{120, diagonal, {1, -1, 0}, {0, 1, -1}}, Case{135, z, {1, 0, 0}, {-1, 1, 0}},
                        Case{150, diagonal, {1, -1, 0}, {-1, 2, -1}}}) {
    SCOPED_TRACE(c.deg);
    const std::vector<Vec3> points{{0, 0, 0}, c.edge, c.u, c.v};
    const verifier::Sites sites(points);
    const auto shape = verifier::make_shape(
        sites.exact_differences<verifier::BigInt, 4>(std::array<VertexId, 4>{0, 1, 2, 3}));
    const auto& pair = verifier::kFacePairs[5];
    ASSERT_EQ(pair.k * 10 + pair.l, 1);
    const auto excess = [&](const std::optional<verifier::Threshold>& t) {
      EXPECT_TRUE(t->small);
      EXPECT_EQ(t->num, verifier::BigInt(t->num_d));
      EXPECT_EQ(t->den, verifier::BigInt(t->den_d));
      return verifier::sign(verifier::cot_excess(
          verifier::signed_square(verifier::cosine_part(shape, pair)),
          verifier::BigInt(shape.det * shape.det * edge_sq(shape, pair)), t->num, t->den));
    };
    const verifier::Bounds bounds = verifier::make_bounds({c.deg, c.deg, 1});
    EXPECT_EQ(excess(bounds.min_angle), 0);
    EXPECT_EQ(excess(bounds.max_angle), 0);
  }
}

TEST(Exact, OtherAnglesAreSeparatedFromTheNextDoubles) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::vector<Vec3> p = random_points(random, 4, 12, 0);
    if (slow_orientation(p) == 0) continue;
    if (slow_orientation(p) < 0) std::swap(p[0], p[1]);
    TetMesh mesh;
    mesh.points = p;
    mesh.tets = {{0, 1, 2, 3}};
    cpp_rational most = -1;
    for (const auto& f : verifier::kFacePairs) most = std::max(most, slow_cos_sq(p, f.k, f.l, f.i, f.j));
    const double cosine = std::copysign(std::sqrt(abs(most).convert_to<double>()), most.convert_to<double>());
    const double deg = verify(mesh, {}).min_dihedral_deg;
    EXPECT_NEAR(std::cos(deg / 180 * std::numbers::pi), cosine, 1e-15);
    EXPECT_TRUE(verify(mesh, guaranteed(deg * (1 - 1e-15), 180, INFINITY)).ok) << deg;
    EXPECT_FALSE(verify(mesh, guaranteed(deg * (1 + 1e-15), 180, INFINITY)).ok) << deg;
  }
}

TEST(Exact, GridPlacesAgreeWithRationals) {
  std::mt19937_64 random(3);
  const auto any = [&](int spread) {
    return std::ldexp(double(std::int64_t(random()) >> 11), -int(random() % unsigned(spread)));
  };
  int on_grid = 0, ties = 0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    const double unit = i % 3 == 0 ? std::ldexp(double(random() % 64 + 64), -20) : std::abs(any(20)) + 1;
    const double origin = i % 2 == 0 ? unit * double(random() % 1000) : any(40);
    double x = origin + unit * double(std::int64_t(random() % 4096) - 2048);
    if (i % 5 == 0) x += unit / 2;
    if (i % 7 == 0) x = std::nextafter(x, 0);
    const verifier::GridPlace place = verifier::GridAxis(unit, origin).place(x);
    ASSERT_TRUE(place.in_range);
    const cpp_rational rest = (cpp_rational(x) - cpp_rational(origin)) / cpp_rational(unit) - place.q;
    EXPECT_LE(abs(rest), cpp_rational(1, 2));
    EXPECT_EQ(place.exact, rest == 0);
    EXPECT_NEAR(place.offset, abs(rest).convert_to<double>(), 1e-15);
    const bool tie = abs(rest) == cpp_rational(1, 2);
    EXPECT_TRUE(!tie || place.q % 2 == 0);
    ties += tie;
    on_grid += place.exact;
  }
  EXPECT_GT(on_grid, 1000);
  EXPECT_GT(ties, 100);
  EXPECT_FALSE(verifier::GridAxis(1e-60, 0).place(1).in_range);
}

TEST(Exact, LatticeMembershipIsAsDefined) {
  const auto slow = [](int level, const std::array<std::int64_t, 3>& q) {
    const int k = level / 2;
    bool corner = true, center = level % 2 == 0;
    for (const std::int64_t x : q) {
      corner &= x % (std::int64_t{1} << k) == 0;
      if (level % 2 == 0) {
        const std::int64_t half = std::int64_t{1} << (k - 1);
        center &= x % half == 0 && (x / half) % 2 != 0;
      }
    }
    return corner || center;
  };
  for (int level = 1; level <= 9; ++level) {
    for (std::int64_t x = -9; x <= 9; ++x) {
      for (std::int64_t y = -9; y <= 9; ++y) {
        for (std::int64_t z = -9; z <= 9; ++z) {
          ASSERT_EQ(verifier::in_lattice(level, {x, y, z}), slow(level, {x, y, z}))
              << level << ": " << x << " " << y << " " << z;
        }
      }
    }
  }
  for (int level = 120; level < 256; ++level) {
    EXPECT_TRUE(verifier::in_lattice(level, {0, 0, 0}));
    EXPECT_FALSE(verifier::in_lattice(level, {0, std::int64_t{1} << 50, 0}));
  }
}

}  // namespace
}  // namespace unsliver
