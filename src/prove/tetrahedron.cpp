#include "prove/tetrahedron.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace unsliver::prover {
namespace {

/// At the edge of corners i and j, between the faces with the other two.
Angle dihedral(const Tetrahedron& t, std::size_t i, std::size_t j) {
  const std::size_t k = i != 0 && j != 0 ? 0 : i != 1 && j != 1 ? 1 : 2, l = 6 - i - j - k;
  const Point edge = t[j] - t[i], m = cross(edge, t[k] - t[i]), n = cross(edge, t[l] - t[i]);
  const std::int64_t c = dot(m, n);
  return Angle({c < 0 ? -c * c : c * c, dot(m, m) * dot(n, n)});
}

std::int64_t length_sq(const Point& a, const Point& b) { return dot(b - a, b - a); }

Point permuted(const Point& p, int symmetry) {
  static constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const std::array<std::int64_t, 3> c{p.x, p.y, p.z};
  const auto& order = kOrders[symmetry >> 3];
  const auto sign = [&](int axis) { return symmetry >> axis & 1 ? -1 : 1; };
  return {sign(0) * c[std::size_t(order[0])], sign(1) * c[std::size_t(order[1])],
          sign(2) * c[std::size_t(order[2])]};
}

}  // namespace

std::string text(const Angle& angle) {
  const Fraction& s = angle.signed_cos_sq();
  const double cosine = std::copysign(std::sqrt(std::abs(double(s.num) / double(s.den))), double(s.num));
  return fmt::format("{:.7g}", std::acos(cosine) * 180 / 3.14159265358979323846);
}

std::string root_text(const Fraction& squared) {
  return fmt::format("{:.5f}", std::sqrt(double(squared.num) / double(squared.den)));
}

std::string text(const Tetrahedron& t) {
  std::string result;
  for (const Point& p : t) result += fmt::format("{}({},{},{})", result.empty() ? "" : " ", p.x, p.y, p.z);
  return result;
}

std::string text(const Shape& shape) {
  return fmt::format("angles in [{}, {}], radius-edge ratio up to {}", text(shape.least),
                     text(shape.greatest), root_text(shape.ratio_sq));
}

std::optional<Circumsphere> Circumsphere::of(const Tetrahedron& t) {
  const Point b = t[1] - t[0], c = t[2] - t[0], d = t[3] - t[0];
  const Point cd = cross(c, d);
  const std::int64_t det = dot(b, cd);
  if (det == 0) return std::nullopt;
  const Point center = dot(b, b) * cd + dot(c, c) * cross(d, b) + dot(d, d) * cross(b, c);
  return det > 0 ? Circumsphere(t[0], center, det) : Circumsphere(t[0], -1 * center, -det);
}

int Circumsphere::compare_center(int axis, std::int64_t bound) const {
  const auto of = [&](const Point& p) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
  const std::int64_t difference = of(center_) - 2 * det_ * (bound - of(corner_));
  return (difference > 0) - (difference < 0);
}

void Shape::include(const Shape& other) {
  least = std::min(least, other.least);
  greatest = std::max(greatest, other.greatest);
  ratio_sq = std::max(ratio_sq, other.ratio_sq);
}

Shape shape_of(const Tetrahedron& t, const Circumsphere& sphere) {
  Shape shape;
  std::int64_t shortest_sq = length_sq(t[0], t[1]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Angle angle = dihedral(t, i, j);
      shape.least = std::min(shape.least, angle);
      shape.greatest = std::max(shape.greatest, angle);
      shortest_sq = std::min(shortest_sq, length_sq(t[i], t[j]));
    }
  const Fraction radius_sq = sphere.radius_sq();
  shape.ratio_sq = {radius_sq.num, radius_sq.den * shortest_sq};
  return shape;
}

Tetrahedron up_to_translation(const Tetrahedron& t) {
  Tetrahedron moved = t;
  std::sort(moved.begin(), moved.end());
  const Point first = moved[0];
  for (Point& p : moved) p = p - first;
  return moved;
}

Tetrahedron up_to_symmetry(const Tetrahedron& t) {
  Tetrahedron least = up_to_translation(t);
  for (int symmetry = 0; symmetry < 48; ++symmetry) {
    Tetrahedron image;
    for (std::size_t i = 0; i < 4; ++i) image[i] = permuted(t[i], symmetry);
    least = std::min(least, up_to_translation(image));
  }
  return least;
}

}  // namespace unsliver::prover
