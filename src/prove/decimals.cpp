#include "prove/decimals.hpp"

#include "prove/enclosure.hpp"

namespace unsliver::prover {
namespace {

/// sign(cos) cos^2 of an angle in thousandths of degrees.
Enclosure signed_cos_sq(int millidegrees) {
  const Enclosure c = cosine_of_millidegrees(millidegrees);
  return millidegrees > 90'000 ? -square(c) : square(c);
}

}  // namespace

bool prints_as(const Angle& angle, int millidegrees) {
  const Enclosure exact(angle.signed_cos_sq());
  return exact.is_certainly_below(signed_cos_sq(millidegrees - 1)) &&
         signed_cos_sq(millidegrees + 1).is_certainly_below(exact);
}

}  // namespace unsliver::prover
