/// \file
/// What the predicates should say: the same signs by textbook formulas in integers of unlimited size.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::exact::reference {

using Integer = boost::multiprecision::cpp_int;
using Point = std::array<Integer, 3>;
using Matrix = std::vector<std::vector<Integer>>;

inline Integer to_integer(double v) { return Integer(v); }
inline Point point(const Vec3& p) { return {to_integer(p.x), to_integer(p.y), to_integer(p.z)}; }

/// Laplace expansion along the first row.
inline Integer determinant(const Matrix& m) {
  if (m.size() == 1) return m[0][0];
  Integer sum = 0;
  for (std::size_t column = 0; column < m.size(); ++column) {
    Matrix minor;
    for (std::size_t i = 1; i < m.size(); ++i) {
      minor.push_back(m[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(column));
    }
    const Integer term = m[0][column] * determinant(minor);
    sum += column % 2 == 0 ? term : Integer(-term);
  }
  return sum;
}

inline int sign(const Integer& v) { return v.sign(); }

/// det of the rows (1, p).
inline int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Matrix m;
  for (const Vec3* p : {&a, &b, &c, &d}) {
    const Point q = point(*p);
    m.push_back({1, q[0], q[1], q[2]});
  }
  return sign(determinant(m));
}

using Five = std::array<Vec3, 5>;

/// det of the rows (1, p, height): its sign is positive if the fifth point is below the lifted hyperplane of
/// the others and these are positively oriented.
inline Integer lifted(const Five& points, const std::array<Integer, 5>& heights) {
  Matrix m;
  for (std::size_t i = 0; i < 5; ++i) {
    const Point q = point(points[i]);
    m.push_back({1, q[0], q[1], q[2], heights[i]});
  }
  return -determinant(m);
}

inline std::array<Integer, 5> paraboloid(const Five& points) {
  std::array<Integer, 5> heights;
  for (std::size_t i = 0; i < 5; ++i) {
    const Point q = point(points[i]);
    heights[i] = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
  }
  return heights;
}

inline int insphere(const Five& p) { return sign(lifted(p, paraboloid(p))); }

inline int power_test(const Five& p, const std::array<double, 5>& w) {
  std::array<Integer, 5> heights = paraboloid(p);
  for (std::size_t i = 0; i < 5; ++i) heights[i] -= to_integer(w[i]);
  return sign(lifted(p, heights));
}

/// A true evaluation at a tiny epsilon: heights times 1/epsilon^5, plus epsilon^(rank - 5). With 1/epsilon
/// beyond twice the largest possible coefficient the leading power dominates all others together.
inline int insphere_perturbed(const Five& p) {
  const Integer inverse_epsilon = Integer(1) << 300;
  std::array<Integer, 5> heights = paraboloid(p);
  for (std::size_t i = 0; i < 5; ++i) {
    unsigned rank = 1;
    for (const Vec3& q : p) rank += lex_less(p[i], q) ? 1U : 0U;
    heights[i] = (heights[i] << 1500) + (Integer(1) << (300 * (5 - rank)));
  }
  return sign(lifted(p, heights));
}

inline Integer dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point difference(const Vec3& a, const Vec3& b) {
  const Point p = point(a), q = point(b);
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

/// Sign of (dihedral angle at the edge of the other two corners) - (acos of sign sqrt(num / den)), by the
/// parts of the edges to i and j that are perpendicular to that edge.
inline int compare_dihedral(const Tet& t, std::size_t i, std::size_t j, int bound_sign, std::int64_t num,
                            std::int64_t den) {
  std::array<std::size_t, 2> rest{};
  for (std::size_t k = 0, n = 0; k < 4; ++k)
    if (k != i && k != j) rest[n++] = k;
  const Point axis = difference(t[rest[1]], t[rest[0]]);
  const Point p = difference(t[i], t[rest[0]]), q = difference(t[j], t[rest[0]]);
  const Integer length = dot(axis, axis);
  const Integer cosine = dot(p, q) * length - dot(p, axis) * dot(q, axis);
  const Integer p_sq = dot(p, p) * length - dot(p, axis) * dot(p, axis);
  const Integer q_sq = dot(q, q) * length - dot(q, axis) * dot(q, axis);
  return sign(Integer(bound_sign * num * p_sq * q_sq - den * cosine * abs(cosine)));
}

/// Sign of (circumradius / shortest edge)^2 - num / den, by the Cayley-Menger determinants.
inline int compare_radius_edge(const Tet& t, std::int64_t num, std::int64_t den) {
  Matrix distances(4, std::vector<Integer>(4)), bordered(5, std::vector<Integer>(5, 1));
  bordered[4][4] = 0;
  Integer shortest = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const Point e = difference(t[i], t[j]);
      distances[i][j] = bordered[i][j] = dot(e, e);
      if (i != j && (shortest < 0 || distances[i][j] < shortest)) shortest = distances[i][j];
    }
  const Integer above = -determinant(distances), below = 2 * determinant(bordered);
  return sign(Integer(den * above - num * shortest * below));
}

}  // namespace unsliver::exact::reference
