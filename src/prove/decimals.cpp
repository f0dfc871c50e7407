#include "prove/decimals.hpp"

#include <fmt/format.h>

namespace unsliver::prover {
namespace {

/// sign(cos) cos^2 of an angle in thousandths of degrees.
Enclosure signed_cos_sq_of(int millidegrees) {
  const Enclosure c = cosine_of_millidegrees(millidegrees);
  return millidegrees > 90'000 ? -square(c) : square(c);
}

bool is_strictly_between(const Enclosure& x, const Enclosure& lo, const Enclosure& hi) {
  return lo.is_certainly_below(x) && x.is_certainly_below(hi);
}

}  // namespace

bool prints_as(const Angle& angle, int millidegrees) {
  return prints_as(Enclosure(angle.signed_cos_sq()), millidegrees);
}

bool prints_as(const Enclosure& signed_cos_sq, int millidegrees) {
  return is_strictly_between(signed_cos_sq, signed_cos_sq_of(millidegrees + 1),
                             signed_cos_sq_of(millidegrees - 1));
}

bool is_below(const Enclosure& signed_cos_sq, int millidegrees) {
  return signed_cos_sq_of(millidegrees).is_certainly_below(signed_cos_sq);
}

std::string degrees_text(const Enclosure& signed_cos_sq) {
  // Rounded to 2^-33, where 3/4 is exact.
  constexpr int kDropped = 3;
  const Enclosure::Raw rounded = (signed_cos_sq.lo() + (1 << (kDropped - 1))) >> kDropped;
  return text(Angle({rounded, Enclosure::Raw{1} << (Enclosure::kBits - kDropped)}));
}

bool root_prints_as(const Enclosure& x_sq, int thousandths) {
  const auto at = [](std::int64_t n) { return Enclosure(Fraction{n * n, 1'000'000}); };
  return is_strictly_between(x_sq, at(thousandths - 1), at(thousandths + 1));
}

std::string thousandths_text(int thousandths) {
  return fmt::format("{}.{:03}", thousandths / 1000, thousandths % 1000);
}

}  // namespace unsliver::prover
