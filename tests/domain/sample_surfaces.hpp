/// \file
/// Surfaces and random shapes that tests of geom and domain build in code.
#pragma once

#include <map>
#include <random>

#include "unsliver/mesh.hpp"

namespace unsliver::samples {

/// Uniform doubles, the same from every compiler.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double in(double lo, double hi) { return lo + (hi - lo) * unit(); }
  std::size_t below(std::size_t n) { return bits_() % n; }
  Vec3 in(const Box3& box) {
    return {in(box.lo.x, box.hi.x), in(box.lo.y, box.hi.y), in(box.lo.z, box.hi.z)};
  }
  Vec3 around(const Vec3& p, double reach) {
    return p + Vec3{in(-reach, reach), in(-reach, reach), in(-reach, reach)};
  }
  Tet tet_around(const Vec3& p, double reach) {
    Tet t{around(p, reach), around(p, reach), around(p, reach), around(p, reach)};
    if (dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) < 0) std::swap(t[2], t[3]);
    return t;
  }
  /// A point of the interior, not too close to the boundary.
  Vec3 inside(const Tet& t) {
    std::array<double, 4> w{};
    double sum = 0;
    for (double& x : w) sum += x = 1e-3 + unit();
    return (w[0] / sum) * t[0] + (w[1] / sum) * t[1] + (w[2] / sum) * t[2] + (w[3] / sum) * t[3];
  }
  Vec3 on(const TriangleMesh& m, std::size_t t) {
    const auto& v = m.triangles[t];
    const double a = unit(), b = unit() * (1 - a);
    return m.points[v[0]] + a * (m.points[v[1]] - m.points[v[0]]) + b * (m.points[v[2]] - m.points[v[0]]);
  }
  /// In the ball of `radius` about p.
  Vec3 in_ball(const Vec3& p, double radius) {
    for (;;) {
      const Vec3 d{in(-1, 1), in(-1, 1), in(-1, 1)};
      if (norm_sq(d) < 1) return p + radius * d;
    }
  }

 private:
  std::mt19937_64 bits_;
};

/// The boundary of a box as an n x n grid of squares a side, cut in two; outward.
inline TriangleMesh box_surface(const Box3& box, int n = 1) {
  TriangleMesh m;
  m.name = "box";
  std::map<std::array<int, 3>, VertexId> ids;
  const auto id = [&](const std::array<int, 3>& q) {
    const auto [it, is_new] = ids.try_emplace(q, static_cast<VertexId>(m.points.size()));
    if (is_new) {
      Vec3 p;
      for (int k = 0; k < 3; ++k)
        p[k] = box.lo[k] + (box.hi[k] - box.lo[k]) * q[static_cast<std::size_t>(k)] / n;
      m.points.push_back(p);
    }
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int u, int v) {
            std::array<int, 3> q{};
            q[axis] = side * n;
            q[(axis + 1) % 3] = u;
            q[(axis + 2) % 3] = v;
            return id(q);
          };
          VertexId a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
          if (side == 0) std::swap(b, d);
          m.triangles.push_back({a, b, c});
          m.triangles.push_back({a, c, d});
        }
  return m;
}

/// A sphere made of 12 n^2 triangles.
inline TriangleMesh sphere_surface(const Vec3& center, double radius, int n) {
  TriangleMesh m = box_surface({{-1, -1, -1}, {1, 1, 1}}, n);
  for (Vec3& p : m.points) p = center + (radius / norm(p)) * p;
  m.name = "sphere";
  return m;
}

inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh m = a;
  m.points.insert(m.points.end(), b.points.begin(), b.points.end());
  const auto shift = static_cast<VertexId>(a.points.size());
  for (const auto& t : b.triangles) m.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return m;
}

inline TriangleMesh inside_out(TriangleMesh m) {
  for (auto& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

}  // namespace unsliver::samples
