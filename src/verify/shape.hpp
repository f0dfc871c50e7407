/// \file
/// The formulas of a tetrahedron, written once for doubles, 128-bit and big integers.
///
/// Notation. Corners p0..p3, a = p1 - p0, b = p2 - p0, c = p3 - p0.
///   normal[i]  the inward normal of the face opposite to corner i, twice the face's area long
///   det        det(a, b, c), six times the signed volume
///   center     2 det (circumcentre - p0) = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b
/// Faces i and j meet in the edge kl of the other two corners, in a dihedral angle t with
///   |n_i||n_j| cos t = -n_i.n_j,  |n_i||n_j| sin t = |det| |p_k - p_l|,
/// so signed cot^2 t, which falls from +oo to -oo over (0, 180) degrees, is a quotient of polynomials.
///
/// Bounds, with M the largest component of a, b, c: |normal| components <= 6 M^2, |det| <= 6 M^3, |center|
/// components <= 18 M^4, squared edges <= 12 M^2, products of two normals <= 36 M^4.
#pragma once

#include "verify/numbers.hpp"

namespace unsliver::verifier {

template <class T>
T dot(const Row<T>& u, const Row<T>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <class T>
Row<T> cross(const Row<T>& u, const Row<T>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

template <class T>
struct Shape {
  std::array<Row<T>, 3> edge;  ///< a, b, c
  std::array<Row<T>, 4> normal;
  T det;
  Row<T> center;
};

template <class T>
Shape<T> make_shape(const std::array<Row<T>, 3>& edge) {
  Shape<T> s;
  s.edge = edge;
  const auto& [a, b, c] = edge;
  s.normal[1] = cross(b, c);
  s.normal[2] = cross(c, a);
  s.normal[3] = cross(a, b);
  s.det = dot(a, s.normal[1]);
  const T aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  for (int i = 0; i < 3; ++i) {
    s.normal[0][i] = -(s.normal[1][i] + s.normal[2][i] + s.normal[3][i]);
    s.center[i] = aa * s.normal[1][i] + bb * s.normal[2][i] + cc * s.normal[3][i];
  }
  return s;
}

/// Faces i and j, and the corners k and l of the edge in which they meet.
struct FacePair {
  int i, j, k, l;
};
inline constexpr std::array<FacePair, 6> kFacePairs{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};

/// |n_i||n_j| cos of the dihedral angle.
template <class T>
T cosine_part(const Shape<T>& s, const FacePair& f) {
  return -dot(s.normal[f.i], s.normal[f.j]);
}

/// The squared length of the edge between the corners k and l of a pair; k < l.
template <class T>
T edge_sq(const Shape<T>& s, const FacePair& f) {
  const Row<T>& head = s.edge[f.l - 1];
  if (f.k == 0) return dot(head, head);
  const Row<T>& tail = s.edge[f.k - 1];
  const Row<T> d{head[0] - tail[0], head[1] - tail[1], head[2] - tail[2]};
  return dot(d, d);
}

template <class T>
T shortest_edge_sq(const Shape<T>& s) {
  T least = edge_sq(s, kFacePairs[0]);
  for (int p = 1; p < 6; ++p) {
    const T e = edge_sq(s, kFacePairs[p]);
    if (e < least) least = e;
  }
  return least;
}

/// x |x|.
template <class T>
T signed_square(const T& x) {
  const T square = x * x;
  return x < 0 ? T(-square) : square;
}

/// Has the sign of (signed cot^2 of the angle) - num / den; signed_cos_sq is |n_i|^2|n_j|^2 cos|cos|,
/// sin_sq is |n_i|^2|n_j|^2 sin^2. Requires: den > 0.
template <class T>
T cot_excess(const T& signed_cos_sq, const T& sin_sq, const T& num, const T& den) {
  return den * signed_cos_sq - num * sin_sq;
}

/// Has the sign of (circumradius / shortest edge)^2 - num / den. Requires: den > 0.
template <class T>
T ratio_excess(const Shape<T>& s, const T& num, const T& den) {
  return den * dot(s.center, s.center) - num * 4 * s.det * s.det * shortest_edge_sq(s);
}

/// Times the sign of det: negative when p0 + d is strictly inside the circumsphere, 0 on it.
template <class T>
T sphere_excess(const Shape<T>& s, const Row<T>& d) {
  return s.det * dot(d, d) - dot(s.center, d);
}

}  // namespace unsliver::verifier
