#include "prove/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace unsliver::prover {
namespace {

using Raw = Enclosure::Raw;
constexpr int kBits = Enclosure::kBits;

/// The largest r with r^2 <= x.
Raw integer_root(Int128 x) {
  Raw root = 0;
  for (Raw bit = Raw{1} << 61; bit != 0; bit >>= 1)
    if (Int128(root + bit) * (root + bit) <= x) root += bit;
  return root;
}

/// pi in units of 2^-36.
Enclosure pi() {
  constexpr Raw kPi = 215'888'603'272;  // 3.14159265358979... 2^36 = 215888603272.35...
  return Enclosure::between(kPi, kPi + 1);
}

}  // namespace

Raw Enclosure::floor_quotient(Int128 a, Int128 b) {
  const Int128 quotient = a / b;
  return checked(quotient - (quotient * b != a && (a < 0) != (b < 0)));
}

Enclosure::Enclosure(const Fraction& f)
    : lo_(floor_quotient(Int128(f.num) << kBits, f.den)), hi_(ceil_quotient(Int128(f.num) << kBits, f.den)) {}

Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  const auto quotient = [&](Raw x, Raw y, bool up) {
    const Int128 scaled = Int128(x) << kBits;
    return up ? Enclosure::ceil_quotient(scaled, y) : Enclosure::floor_quotient(scaled, y);
  };
  return Enclosure(std::min({quotient(a.lo_, b.lo_, false), quotient(a.lo_, b.hi_, false),
                             quotient(a.hi_, b.lo_, false), quotient(a.hi_, b.hi_, false)}),
                   std::max({quotient(a.lo_, b.lo_, true), quotient(a.lo_, b.hi_, true),
                             quotient(a.hi_, b.lo_, true), quotient(a.hi_, b.hi_, true)}));
}

Enclosure square_root(const Enclosure& x) {
  return Enclosure::between(integer_root(Int128(x.lo()) << kBits), integer_root(Int128(x.hi()) << kBits) + 1);
}

Enclosure square(const Enclosure& x) {
  const Enclosure product = x * x;
  return Enclosure::between(std::max<Raw>(product.lo(), 0), product.hi());
}

Enclosure cosine_of_millidegrees(int millidegrees) {
  const Enclosure x = pi() * Enclosure(Fraction{millidegrees, 180'000}), x_sq = square(x);
  // cos x = sum (-1)^n x^2n / (2n)!; from the third term on they fall for x < pi, so that the next one bounds
  // the rest.
  Enclosure sum = 1, term = 1;
  for (int n = 1; n <= 12; ++n) {
    term = -(term * x_sq) / Enclosure((2 * n - 1) * (2 * n));
    sum = sum + term;
  }
  const Raw rest = std::max(std::abs(term.lo()), std::abs(term.hi()));
  return sum + Enclosure::between(-rest, rest);
}

double middle(const Enclosure& x) { return std::ldexp(double(x.lo()) + double(x.width()) / 2, -kBits); }

std::string text(const Enclosure& x) { return fmt::format("{:.6g}", middle(x)); }

}  // namespace unsliver::prover
