#include "lattice/forbidden_region.hpp"

namespace unsliver::lattice {
namespace {

__extension__ using Uint128 = unsigned __int128;

/// n <= 2^48 (2 + sqrt 6)/4, that is 4n - 2^49 <= 2^48 sqrt 6. Requires 4n >= 2^49.
constexpr bool at_most_sigma_bits(std::int64_t n) {
  const auto rest = Uint128(4 * n - (std::int64_t{1} << 49));
  return rest * rest <= Uint128(6) << 96;
}
static_assert(at_most_sigma_bits(kSigmaBits) && !at_most_sigma_bits(kSigmaBits + 1));

/// c > (2 + sqrt 6)/4 for c = n / 2^53, that is (4n - 2^54)^2 > 2^106 6.
constexpr bool above_sigma(std::int64_t n) {
  const auto rest = Uint128(4 * n - (std::int64_t{1} << 54));
  return rest * rest > Uint128(6) << 106;
}
// Doubles in [1, 2) are even multiples of 2^-53: sigma lies between the midpoints next to kSigma.
static_assert(above_sigma(std::int64_t(kSigma * 0x1p53) + 1) &&
              !above_sigma(std::int64_t(kSigma * 0x1p53) - 1));

}  // namespace
}  // namespace unsliver::lattice
