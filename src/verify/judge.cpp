#include "verify/judge.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace unsliver::verifier {
namespace {

using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

// Differences of at most this many significant bits make the polynomial exact in 53-bit doubles, by the
// bounds in shape.hpp: 6 M^3, 72 M^5, and 1296 M^8 times a threshold below 2^10.
constexpr int kExactOrientationBits = 16, kExactSphereBits = 9, kExactQualityBits = 4;
// The same for 127-bit integers; orientation computes `center` on the way.
constexpr int kInt128OrientationBits = 30, kInt128SphereBits = 23, kInt128QualityBits = 13;

// Forward error bounds in roundings, times M^3, M^5 or M^8 (docs/VERIFY.md), rounded up.
constexpr double kOrientationError = 64, kSphereError = 2000;
constexpr double kCosineError = 5e4, kSineError = 2e4;
constexpr double kRadiusError = 4e4, kEdgeError = 6e4;

double largest_component(const Row<double>& d, double so_far) {
  return std::max({so_far, std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
}

double power_5(double m) { return m * m * m * m * m; }
double power_8(double m) {
  const double m4 = m * m * m * m;
  return m4 * m4;
}

/// Error of a polynomial `count` roundings wide; unbounded where its powers could overflow or underflow.
double error_bound(double count, double power, double reach) {
  return reach > 0x1p-100 && reach < 0x1p100 ? count * kRoundoff * power : INFINITY;
}

template <class T>
T exact_number(const BigInt& x) {
  return static_cast<T>(x);
}

/// The larger excess over the bounds of any of the six angles, as signs, in the numbers T.
template <class T>
Verdict judge_shape(const Shape<T>& s, const Bounds& bounds) {
  Verdict verdict;
  const T det_sq = s.det * s.det;
  for (const FacePair& f : kFacePairs) {
    const T cos_sq = signed_square(cosine_part(s, f));
    const T sin_sq = det_sq * edge_sq(s, f);
    const auto excess = [&](const Threshold& t) {
      return sign(cot_excess(cos_sq, sin_sq, exact_number<T>(t.num), exact_number<T>(t.den)));
    };
    if (bounds.min_angle) verdict.min_angle = std::max(verdict.min_angle, excess(*bounds.min_angle));
    if (bounds.max_angle) verdict.max_angle = std::max(verdict.max_angle, -excess(*bounds.max_angle));
  }
  if (const auto& r = bounds.ratio) {
    verdict.ratio = sign(ratio_excess(s, exact_number<T>(r->num), exact_number<T>(r->den)));
  }
  return verdict;
}

bool all_small(const Bounds& b) {
  const auto fine = [](const std::optional<Threshold>& t) { return !t || t->small; };
  return fine(b.min_angle) && fine(b.max_angle) && fine(b.ratio);
}

/// Signed cot^2 as an angle in degrees.
Real degrees(const BigInt& signed_cos_sq, const BigInt& sin_sq) {
  const Real cosine = sqrt(Real(abs(signed_cos_sq)));
  const Real angle = atan2(sqrt(Real(sin_sq)), signed_cos_sq < 0 ? Real(-cosine) : cosine);
  return angle * 180 / boost::math::constants::pi<Real>();
}

}  // namespace

Candidate Judge::candidate(const std::array<VertexId, 4>& v) {
  Candidate c;
  c.v = v;
  std::array<Row<double>, 3> edge;
  for (int i = 0; i < 3; ++i) {
    edge[i] = sites_.difference(v[i + 1], v[0], c.spread);
    c.reach = largest_component(edge[i], c.reach);
  }
  c.shape = make_shape(edge);
  const int bits = significant_bits(c.spread);
  const double cube = c.reach * c.reach * c.reach;
  const double error = bits <= kExactOrientationBits ? 0 : error_bound(kOrientationError, cube, c.reach);
  if (const auto decided = settled(c.shape.det, error)) {
    c.orientation = *decided;
    return c;
  }
  ++exact_;
  c.orientation = bits <= kInt128OrientationBits ? sign(make_shape(sites_.exact_differences<Int128>(v)).det)
                                                 : sign(make_shape(sites_.exact_differences<BigInt>(v)).det);
  return c;
}

Verdict Judge::quality(const Candidate& c) {
  if (const auto verdict = quality_in_doubles(c)) return *verdict;
  ++exact_;
  return significant_bits(c.spread) <= kInt128QualityBits && all_small(bounds_)
             ? quality_in_integers<Int128>(c)
             : quality_in_integers<BigInt>(c);
}

std::optional<Verdict> Judge::quality_in_doubles(const Candidate& c) {
  const Shape<double>& s = c.shape;
  const int bits = significant_bits(c.spread);
  const double det_sq = s.det * s.det, m8 = power_8(c.reach);
  const auto worst_angle = [&](const Threshold& t, double direction) {
    double worst = -INFINITY;
    for (const FacePair& f : kFacePairs) {
      const double x = cot_excess(signed_square(cosine_part(s, f)), det_sq * edge_sq(s, f), t.num_d, t.den_d);
      worst = std::max(worst, direction * x);
    }
    return worst;
  };
  const auto decide = [&](const Threshold& t, double value, double by_den, double by_num) {
    const bool exact = t.small && bits <= kExactQualityBits;
    const double count = by_den * t.den_d + by_num * std::abs(t.num_d);
    return settled(value, exact ? 0 : error_bound(count, m8, c.reach));
  };
  Verdict verdict;
  if (const auto& t = bounds_.min_angle) {
    const auto decided = decide(*t, worst_angle(*t, 1), kCosineError, kSineError);
    if (!decided) return std::nullopt;
    verdict.min_angle = *decided;
  }
  if (const auto& t = bounds_.max_angle) {
    const auto decided = decide(*t, worst_angle(*t, -1), kCosineError, kSineError);
    if (!decided) return std::nullopt;
    verdict.max_angle = *decided;
  }
  if (const auto& t = bounds_.ratio) {
    const auto decided = decide(*t, ratio_excess(s, t->num_d, t->den_d), kRadiusError, kEdgeError);
    if (!decided) return std::nullopt;
    verdict.ratio = *decided;
  }
  return verdict;
}

template <class T>
Verdict Judge::quality_in_integers(const Candidate& c) {
  return judge_shape(make_shape(sites_.exact_differences<T>(c.v)), bounds_);
}

Measures Judge::measures(const Candidate& c) const {
  const Shape<double>& s = c.shape;
  const double det_sq = s.det * s.det;
  Measures m{-INFINITY, INFINITY, 0};
  double shortest = INFINITY;
  for (const FacePair& f : kFacePairs) {
    const double e = edge_sq(s, f);
    const double cot = signed_square(cosine_part(s, f)) / (det_sq * e);
    shortest = std::min(shortest, e);
    m.largest_cot = std::max(m.largest_cot, cot);
    m.smallest_cot = std::min(m.smallest_cot, cot);
  }
  m.ratio_sq = dot(s.center, s.center) / (4 * det_sq * shortest);
  return m;
}

int Judge::in_sphere(const Candidate& c, VertexId e) {
  std::uint64_t spread = c.spread;
  const Row<double> d = sites_.difference(e, c.v[0], spread);
  const int bits = significant_bits(spread);
  const double reach = largest_component(d, c.reach);
  const double error = bits <= kExactSphereBits ? 0 : error_bound(kSphereError, power_5(reach), reach);
  if (const auto decided = settled(sphere_excess(c.shape, d), error)) return -*decided * c.orientation;
  ++exact_;
  return bits <= kInt128SphereBits ? in_sphere_in_integers<Int128>(c, e)
                                   : in_sphere_in_integers<BigInt>(c, e);
}

template <class T>
int Judge::in_sphere_in_integers(const Candidate& c, VertexId e) const {
  const std::array<VertexId, 5> v{c.v[0], c.v[1], c.v[2], c.v[3], e};
  const auto d = sites_.exact_differences<T>(v);
  return -sign(sphere_excess(make_shape<T>({d[0], d[1], d[2]}), d[3])) * c.orientation;
}

FineMeasures Judge::fine_measures(const std::array<VertexId, 4>& v) const {
  const auto s = make_shape(sites_.exact_differences<BigInt>(v));
  if (s.det == 0) return {0, 180, INFINITY};
  const BigInt det_sq = s.det * s.det;
  Real least = 180, most = 0;
  for (const FacePair& f : kFacePairs) {
    const Real angle = degrees(signed_square(cosine_part(s, f)), det_sq * edge_sq(s, f));
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  const Real ratio = sqrt(Real(dot(s.center, s.center)) / Real(BigInt(4 * det_sq * shortest_edge_sq(s))));
  return {least.convert_to<double>(), most.convert_to<double>(), ratio.convert_to<double>()};
}

}  // namespace unsliver::verifier
