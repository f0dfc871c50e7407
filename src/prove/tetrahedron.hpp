/// \file
/// Tetrahedra with small integer corners: circumspheres, angles and ratios, all exact.
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "prove/angle.hpp"

namespace unsliver::prover {

struct Point {
  std::int64_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const Point&, const Point&) = default;
};

constexpr Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point operator*(std::int64_t s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr std::int64_t dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Tetrahedron = std::array<Point, 4>;

/// "(0,0,0) (1,0,0) (0,1,0) (0,0,1)"
std::string text(const Tetrahedron& t);

/// The sphere through the corners of a tetrahedron that is not flat. Requires coordinates of magnitude up to
/// 2^5, here and below: then no product leaves 64 bits.
class Circumsphere {
 public:
  static std::optional<Circumsphere> of(const Tetrahedron& t);

  /// > 0: p is strictly inside, 0: on the sphere.
  int side(const Point& p) const {
    const Point d = p - corner_;
    const std::int64_t power = dot(d, center_) - dot(d, d) * det_;
    return (power > 0) - (power < 0);
  }
  bool holds_inside(const Point& p) const { return side(p) > 0; }
  Fraction radius_sq() const { return {dot(center_, center_), 4 * det_ * det_}; }
  /// sign(coordinate of the centre - bound), axis 0, 1 or 2.
  int compare_center(int axis, std::int64_t bound) const;

 private:
  Circumsphere(const Point& corner, const Point& center, std::int64_t det)
      : corner_(corner), center_(center), det_(det) {}

  Point corner_;
  Point center_;      ///< (centre - corner_) * 2 det_
  std::int64_t det_;  ///< six times the volume, > 0
};

/// Extremes of one tetrahedron or of many.
struct Shape {
  Angle least = Angle({-1, 1}), greatest = Angle({1, 1});
  Fraction ratio_sq{0, 1};  ///< squared radius-edge ratio, the largest

  void include(const Shape& other);
  bool within(const Angle& lo, const Angle& hi, const Fraction& largest_ratio_sq) const {
    return least >= lo && greatest <= hi && ratio_sq <= largest_ratio_sq;
  }
};

/// Requires a tetrahedron that is not flat, and its circumsphere.
Shape shape_of(const Tetrahedron& t, const Circumsphere& sphere);

/// "angles in [30, 135], radius-edge ratio up to 1.1180"
std::string text(const Shape& shape);

/// The same tetrahedron moved by a translation, corners sorted, the first at the origin.
Tetrahedron up_to_translation(const Tetrahedron& t);
/// One representative of all images under the cube's 48 symmetries and translations.
Tetrahedron up_to_symmetry(const Tetrahedron& t);

/// All integer points with |x|, |y|, |z| <= reach that satisfy the condition, the origin left out.
template <class Condition>
std::vector<Point> points_around_origin(int reach, const Condition& condition) {
  std::vector<Point> points;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -reach; z <= reach; ++z)
        if ((x != 0 || y != 0 || z != 0) && condition(Point{x, y, z})) points.push_back({x, y, z});
  return points;
}

/// visit(t, sphere) for each tetrahedron of the origin and three of the points that is not flat.
template <class Visit>
void for_each_tetrahedron_at_origin(const std::vector<Point>& points, const Visit& visit) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Tetrahedron t{Point{}, points[i], points[j], points[k]};
        if (const auto sphere = Circumsphere::of(t)) visit(t, *sphere);
      }
}

}  // namespace unsliver::prover
