#include "verify/bounds.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace unsliver::verifier {
namespace {

using Real = mp::number<mp::cpp_bin_float<400, mp::digit_base_2>, mp::et_off>;

constexpr int kFractionBits = 200;

Threshold small_threshold(int num, int den) { return {num, den, double(num), double(den), true}; }

/// The angles whose squared cotangent is rational (Niven's theorem leaves no others).
std::optional<Threshold> rational_angle(double deg) {
  if (deg == 30) return small_threshold(3, 1);
  if (deg == 45) return small_threshold(1, 1);
  if (deg == 60) return small_threshold(1, 3);
  if (deg == 90) return small_threshold(0, 1);
  if (deg == 120) return small_threshold(-1, 3);
  if (deg == 135) return small_threshold(-1, 1);
  if (deg == 150) return small_threshold(-3, 1);
  return std::nullopt;
}

/// Signed cot^2, moved by one or two steps of 2^-200 up (slack = 1) or down (slack = -1).
Threshold angle_threshold(double deg, int slack) {
  if (const auto exact = rational_angle(deg)) return *exact;
  const Real angle = Real(deg) * boost::math::constants::pi<Real>() / 180;
  const Real cot = cos(angle) / sin(angle);
  const Real value = cot < 0 ? Real(-cot * cot) : Real(cot * cot);
  BigInt num(floor(ldexp(value, kFractionBits)));
  num += slack > 0 ? 2 : -1;
  return {num, BigInt(1) << kFractionBits, value.convert_to<double>(), 1.0, false};
}

Threshold ratio_threshold(double ratio) {
  constexpr double kHalfRootFive = 1.118033988749895;
  if (std::abs(ratio - kHalfRootFive) < 1e-15) return small_threshold(5, 4);
  const Dyadic d = decompose(ratio);
  const BigInt square = BigInt(d.mantissa) * d.mantissa;
  const double rounded = ratio * ratio;
  if (d.exponent >= 0) return {BigInt(square << 2 * d.exponent), 1, rounded, 1.0, false};
  return {square, BigInt(1) << -2 * d.exponent, rounded, 1.0, false};
}

}  // namespace

Bounds make_bounds(const QualityGuarantee& g) {
  Bounds bounds;
  if (g.min_dihedral_deg > 0) bounds.min_angle = angle_threshold(g.min_dihedral_deg, 1);
  if (g.max_dihedral_deg < 180) bounds.max_angle = angle_threshold(g.max_dihedral_deg, -1);
  if (g.max_radius_edge < INFINITY) bounds.ratio = ratio_threshold(g.max_radius_edge);
  return bounds;
}

}  // namespace unsliver::verifier
