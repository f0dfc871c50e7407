#include "prove/surd.hpp"

namespace unsliver::prover {

Enclosure enclosure_of(const SurdFraction& f) {
  // (a + b sqrt 6) / c with integers, c > 0.
  const Surd conjugate = f.den.conjugate();
  const Surd product = f.num * conjugate;
  Surd::Integer a = product.a(), b = product.b(), c = (f.den * conjugate).a();
  if (c < 0) a = -a, b = -b, c = -c;
  constexpr int kBits = 96;
  const Surd::Integer root = sqrt(Surd::Integer(6) << (2 * kBits));  // rounded down
  const Surd::Integer other = b * root, slack = abs(b);
  const Surd::Integer scale = c << (kBits - Enclosure::kBits);
  // Division truncates: shifted to where all is positive, that rounds down.
  constexpr Enclosure::Raw kShift = Enclosure::Raw{1} << 62;
  const auto floor = [&](const Surd::Integer& x) {
    const Surd::Integer shifted = x + scale * kShift;
    return Surd::Integer(shifted / scale).convert_to<Enclosure::Raw>() - kShift;
  };
  const Surd::Integer value = (a << kBits) + other;
  return Enclosure::between(floor(value - slack), floor(value + slack) + 1);
}

}  // namespace unsliver::prover
