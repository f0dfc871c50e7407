/// \file
/// Lattices by their definitions, in integers, and random points: shares nothing with src/lattice.
#pragma once

#include <cstdint>
#include <ostream>
#include <random>

#include "lattice/level.hpp"

namespace unsliver {

inline std::ostream& operator<<(std::ostream& out, const Vec3& p) {
  out.precision(17);
  return out << "(" << p.x << ", " << p.y << ", " << p.z << ")";
}

}  // namespace unsliver

namespace unsliver::lattice::reference {

struct Point {
  std::int64_t x, y, z;
};

inline Point to_point(const Vec3& p) { return {std::int64_t(p.x), std::int64_t(p.y), std::int64_t(p.z)}; }
inline Vec3 to_vec(const Point& p) { return {double(p.x), double(p.y), double(p.z)}; }

/// SC_k: all coordinates are multiples of 2^k.
inline bool in_sc(int k, const Point& p) {
  const std::int64_t side = std::int64_t{1} << k;
  return p.x % side == 0 && p.y % side == 0 && p.z % side == 0;
}

/// BCC_k, k >= 1: SC_k and the centres of its cells.
inline bool in_bcc(int k, const Point& p) {
  const std::int64_t half = std::int64_t{1} << (k - 1);
  return in_sc(k, p) || in_sc(k, {p.x - half, p.y - half, p.z - half});
}

inline bool on_lattice(Level level, const Point& p) {
  return level % 2 == 0 ? in_bcc(level / 2, p) : in_sc(level / 2, p);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// Uniform in [lo, hi].
  std::int64_t integer(std::int64_t lo, std::int64_t hi) {
    return lo + std::int64_t(bits_() % (std::uint64_t(hi - lo) + 1));
  }
  double real(double lo, double hi) { return lo + (hi - lo) * 0x1p-53 * double(bits_() >> 11); }

  /// Coordinates in [-bound, bound].
  Point point(std::int64_t bound) {
    return {integer(-bound, bound), integer(-bound, bound), integer(-bound, bound)};
  }
  /// Coordinates whose magnitudes are spread evenly over the powers of two below 2^48.
  Point wide_point() { return {integer(-1, 1) * wide(), integer(-1, 1) * wide(), integer(-1, 1) * wide()}; }
  /// A point of the level's lattice with coordinates in (-2^48, 2^48), all magnitudes.
  Point lattice_point(Level level) {
    const int k = level / 2;
    const int bits = int(integer(0, 48 - k));
    const std::int64_t side = std::int64_t{1} << k, count = (std::int64_t{1} << bits) - 1;
    const std::int64_t half = level % 2 == 0 ? integer(0, 1) * (side / 2) : 0;
    const auto coordinate = [&] { return integer(half > 0 ? -count - 1 : -count, count) * side + half; };
    const std::int64_t x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

 private:
  std::int64_t wide() { return integer(0, (std::int64_t{1} << integer(0, 48)) - 1); }
  std::mt19937_64 bits_;
};

}  // namespace unsliver::lattice::reference
