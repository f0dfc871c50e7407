/// \file
/// Differences of points as integers without their common power of two.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "exact/determinants.hpp"

namespace unsliver::exact {

/// The power of two common to some integers, and what remains.
struct Scale {
  int shift = 0;  ///< g = 2^shift
  int bits = 0;   ///< the absolute values over g are below 2^bits
};

/// g^power as a double. Requires: shift * power < 1024.
inline double power_of_g(const Scale& scale, int power) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + scale.shift * power) << 52);
}

/// Rows as 64-bit integers. Requires: integers below 2^62.
template <std::size_t kRows>
struct IntegerRows {
  std::array<Row<std::int64_t>, kRows> rows;
  Scale scale;

  explicit IntegerRows(const std::array<Row<double>, kRows>& exact) {
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < kRows; ++i) {
      rows[i] = {static_cast<std::int64_t>(exact[i].x), static_cast<std::int64_t>(exact[i].y),
                 static_cast<std::int64_t>(exact[i].z)};
      mask |= magnitude(rows[i].x) | magnitude(rows[i].y) | magnitude(rows[i].z);
    }
    if (mask == 0) return;
    scale.shift = std::countr_zero(mask);
    scale.bits = static_cast<int>(std::bit_width(mask)) - scale.shift;
  }

  /// Divides the rows by g.
  void reduce() {
    for (Row<std::int64_t>& r : rows) r = {r.x >> scale.shift, r.y >> scale.shift, r.z >> scale.shift};
  }

 private:
  static std::uint64_t magnitude(std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); }
};

}  // namespace unsliver::exact
