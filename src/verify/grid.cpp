#include "verify/grid.hpp"

#include <algorithm>

namespace unsliver::verifier {

GridAxis::GridAxis(double unit, double origin) : unit_(unit), origin_(origin) {
  const int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(decompose(unit).mantissa)));
  exact_limit_ = std::min(std::ldexp(1.0, 53 - bits), 0x1p49);
}

GridPlace GridAxis::place(double x) const {
  const double q = std::nearbyint((x - origin_) / unit_);
  if (!(std::abs(q) <= exact_limit_)) return place_slowly(x);
  // The quotient errs by less than 1/2, so no other integer can fit, and the product is exact: x is on the
  // grid if and only if the sum is exact too (Knuth's two-sum) and is x.
  const double step = unit_ * q, sum = origin_ + step;
  const double step_part = sum - origin_;
  const double lost = (origin_ - (sum - step_part)) + (step - step_part);
  if (lost == 0 && sum == x) return {true, true, static_cast<std::int64_t>(q), 0};
  return place_slowly(x);
}

GridPlace GridAxis::place_slowly(double x) const {
  const int exponent =
      std::min({decompose(x).exponent, decompose(origin_).exponent, decompose(unit_).exponent});
  const BigInt distance = scaled(x, exponent) - scaled(origin_, exponent);
  const BigInt unit = scaled(unit_, exponent);
  BigInt q, rest;
  mp::divide_qr(BigInt(abs(distance)), unit, q, rest);
  const int half = BigInt(2 * rest).compare(unit);
  if (half > 0 || (half == 0 && q % 2 != 0)) {
    ++q;
    rest = unit - rest;
  }
  if (q > kGridLimit) return {};
  const auto size = static_cast<std::int64_t>(q);
  const double offset = mp::cpp_rational(rest.backend(), unit.backend()).convert_to<double>();
  return {true, rest == 0, distance < 0 ? -size : size, offset};
}

}  // namespace unsliver::verifier
