/// \file
/// Random and degenerate integer points.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <utility>

#include "unsliver/types.hpp"

namespace unsliver::exact {

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, n).
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  /// An integer in (-2^bits, 2^bits).
  double integer(int bits) {
    const double magnitude = static_cast<double>(engine_() >> (64 - bits));
    return below(2) ? magnitude : -magnitude;
  }
  Vec3 vector(int bits) { return {integer(bits), integer(bits), integer(bits)}; }

  template <std::size_t kCount>
  std::array<Vec3, kCount> vectors(int bits) {
    std::array<Vec3, kCount> points;
    for (Vec3& p : points) p = vector(bits);
    return points;
  }

  /// One of the 48 signed permutations of p: all on one sphere around the origin.
  Vec3 mirrored(Vec3 p) {
    if (below(2)) std::swap(p.x, p.y);
    if (below(2)) std::swap(p.y, p.z);
    if (below(2)) std::swap(p.x, p.z);
    return {below(2) ? p.x : -p.x, below(2) ? p.y : -p.y, below(2) ? p.z : -p.z};
  }

  /// Exactly cospherical points, up to 2^bits.
  template <std::size_t kCount>
  std::array<Vec3, kCount> cospherical(int bits) {
    const Vec3 p = vector(bits - 1), center = vector(bits - 1);
    std::array<Vec3, kCount> points;
    for (Vec3& q : points) q = mirrored(p) + center;
    return points;
  }

  /// Exactly coplanar points, up to 2^(2 bits + 2).
  template <std::size_t kCount>
  std::array<Vec3, kCount> coplanar(int bits) {
    const Vec3 u = vector(bits), v = vector(bits), origin = vector(2 * bits);
    std::array<Vec3, kCount> points;
    for (Vec3& q : points) q = origin + integer(bits) * u + integer(bits) * v;
    return points;
  }

  /// Moves one coordinate of one of the points by one unit.
  template <std::size_t kCount>
  void nudge(std::array<Vec3, kCount>& points) {
    points[below(kCount)][static_cast<int>(below(3))] += below(2) ? 1.0 : -1.0;
  }

  /// Points of a cubic (or, `centred`, body-centred) lattice patch of cells of `side` = a power of two.
  template <std::size_t kCount>
  std::array<Vec3, kCount> lattice(int cells, double side, bool centred) {
    const Vec3 origin = side * vector(8);
    std::array<Vec3, kCount> points;
    for (Vec3& q : points) {
      const double shift = centred && below(2) ? 1 : 0;
      for (int axis = 0; axis < 3; ++axis)
        q[axis] = side / 2 * (2 * static_cast<double>(below(static_cast<std::uint64_t>(cells))) + shift);
      q = q + origin;
    }
    return points;
  }

 private:
  std::mt19937_64 engine_;
};

/// The last of the points equals none of the others.
template <std::size_t kCount>
bool last_is_distinct(const std::array<Vec3, kCount>& points) {
  for (std::size_t i = 0; i + 1 < kCount; ++i)
    if (points[i] == points.back()) return false;
  return true;
}

}  // namespace unsliver::exact
