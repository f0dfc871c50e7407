/// \file
/// Angles and ratios of a tetrahedron with one corner that is not on the lattice, in any arithmetic.
#pragma once

#include <array>

#include "prove/tetrahedron.hpp"

namespace unsliver::prover {

template <class T>
struct Vector {
  T x, y, z;
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator*(const T& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length_sq(const Vector<T>& a) {
  return dot(a, a);
}

/// A lattice point in units of 1/scale.
template <class T>
Vector<T> vector(const Point& p, int scale) {
  return {T(int(p.x) * scale), T(int(p.y) * scale), T(int(p.z) * scale)};
}

template <class T>
struct Quotient {
  T num, den;  ///< den > 0 where the tetrahedron is not flat
};

/// One number that a tetrahedron (a, b, c, p), p corner 3, has at the edge of corners i < j.
struct Quantity {
  enum Kind {
    kSmallAngle,  ///< sign(cos) cos^2 of the dihedral angle: large for small angles
    kLargeAngle,  ///< the same negated: large for large angles
    kRatio,       ///< squared circumradius over squared length of the edge
  };
  Kind kind;
  std::array<Point, 3> base;  ///< a, b, c
  int i, j;

  /// Coordinates of p in units of 1/scale; numbers T(int) and signed_square(T) are asked for.
  template <class T>
  Quotient<T> at(const Vector<T>& p, int scale) const {
    const std::array<Vector<T>, 4> t{vector<T>(base[0], scale), vector<T>(base[1], scale),
                                     vector<T>(base[2], scale), p};
    return kind == kRatio ? ratio(t) : cosine(t);
  }

 private:
  template <class T>
  Quotient<T> cosine(const std::array<Vector<T>, 4>& t) const {
    // Corner i is on the lattice: products stay of low degree in p.
    const auto first = std::size_t(i), second = std::size_t(j);
    const std::size_t k = i != 0 ? 0 : j != 1 ? 1 : 2, l = 6 - first - second - k;
    const Vector<T> edge = t[second] - t[first];
    const Vector<T> m = cross(edge, t[k] - t[first]), n = cross(edge, t[l] - t[first]);
    const T num = signed_square(dot(m, n));
    return {kind == kSmallAngle ? num : -num, length_sq(m) * length_sq(n)};
  }

  template <class T>
  Quotient<T> ratio(const std::array<Vector<T>, 4>& t) const {
    const Vector<T> b = t[1] - t[0], c = t[2] - t[0], d = t[3] - t[0];
    const Vector<T> bc = cross(b, c);
    const T det = dot(d, bc);
    const Vector<T> center = length_sq(b) * cross(c, d) + length_sq(c) * cross(d, b) + length_sq(d) * bc;
    const T edge_sq = length_sq(t[std::size_t(j)] - t[std::size_t(i)]);
    return {length_sq(center), T(4) * det * det * edge_sq};
  }
};

}  // namespace unsliver::prover
