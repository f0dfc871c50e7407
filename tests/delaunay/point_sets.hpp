/// \file
/// Point sets for tests of the kernel: random, lattice, spherical, clustered, nearly coplanar. Integers held
/// in doubles.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::test {

using Random = std::mt19937_64;

inline double uniform_integer(Random& random, double below) {
  return std::floor(static_cast<double>(random() >> 11) * 0x1p-53 * below);
}

inline Vec3 uniform_point(Random& random, double side) {
  return {uniform_integer(random, side), uniform_integer(random, side), uniform_integer(random, side)};
}

inline void shuffle(std::vector<Vec3>& points, Random& random) {
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
}

struct NamedPoints {
  std::string name;
  std::vector<Vec3> points;
};

inline std::vector<Vec3> uniform_points(std::size_t n, double side, Random& random) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(uniform_point(random, side));
  return points;
}

/// n^3 points of spacing `step`; with centres (BCC) if asked.
inline std::vector<Vec3> lattice_points(int n, double step, bool centres) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        points.push_back({i * step, j * step, k * step});
        if (centres) points.push_back({(i + 0.5) * step, (j + 0.5) * step, (k + 0.5) * step});
      }
  return points;
}

/// Points of the integer sphere x^2 + y^2 + z^2 = 3^2 5^2 7^2 13^2 scaled: many exact cospherical points.
inline std::vector<Vec3> cospherical_points() {
  const int r = 105;
  std::vector<Vec3> points;
  for (int x = -r; x <= r; ++x)
    for (int y = -r; y <= r; ++y)
      for (int z = -r; z <= r; ++z)
        if (x * x + y * y + z * z == r * r) points.push_back({double(x), double(y), double(z)});
  return points;
}

inline std::vector<NamedPoints> point_sets(std::uint64_t seed) {
  Random random(seed);
  std::vector<NamedPoints> sets;
  sets.push_back({"uniform", uniform_points(600, 0x1p47, random)});
  sets.push_back({"tiny grid with many duplicates", uniform_points(600, 6, random)});
  sets.push_back({"simple cubic", lattice_points(7, 16, false)});
  sets.push_back({"body-centred cubic", lattice_points(5, 16, true)});
  sets.push_back({"cospherical", cospherical_points()});
  std::vector<Vec3> clustered;
  for (int c = 0; c < 6; ++c) {
    const Vec3 centre = uniform_point(random, 0x1p46);
    for (int i = 0; i < 80; ++i) clustered.push_back(centre + uniform_point(random, 64));
  }
  sets.push_back({"clustered", clustered});
  std::vector<Vec3> flat;
  for (int i = 0; i < 400; ++i)
    flat.push_back(
        {uniform_integer(random, 0x1p40), uniform_integer(random, 0x1p40), uniform_integer(random, 2)});
  sets.push_back({"nearly coplanar", flat});
  std::vector<Vec3> planar = lattice_points(8, 4, false);
  for (Vec3& p : planar) p.z = p.x + p.y;  // 64 points of one slanted plane, many times over
  planar.push_back({3, 5, 1000});
  sets.push_back({"coplanar and one apex", planar});
  return sets;
}

}  // namespace unsliver::test
