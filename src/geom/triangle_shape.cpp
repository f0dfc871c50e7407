#include "geom/triangle_shape.hpp"

#include <cmath>

namespace unsliver::geom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kPi = 3.141592653589793;

/// Below this height / longest edge a triangle's normal is too noisy: it is taken for its three edges.
constexpr double kFlat = 1e-7;

double longest_edge_sq(const Triangle& t) {
  return std::max({dist_sq(t[0], t[1]), dist_sq(t[1], t[2]), dist_sq(t[2], t[0])});
}

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double along = dot(p - a, ab), length_sq = norm_sq(ab);
  if (!(along > 0)) return a;
  return along < length_sq ? a + (along / length_sq) * ab : b;
}

/// Is p in the prism over the triangle?
bool projects_inside(const Triangle& t, const Vec3& normal, const Vec3& p) {
  for (int i = 0; i < 3; ++i) {
    const Vec3& a = t[i];
    if (!(dot(cross(t[(i + 1) % 3] - a, p - a), normal) >= 0)) return false;
  }
  return true;
}

/// atan(t) for |t| <= tan(pi / 8): the Taylor series, whose first omitted term is below 1.3e-7.
double small_atan(double t) {
  const double s = t * t;
  return t * (1 - s * (1.0 / 3 - s * (1.0 / 5 - s * (1.0 / 7 - s * (1.0 / 9 - s * (1.0 / 11 - s / 13))))));
}

/// atan2(y, x) to 1e-7.
double angle_of(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  const double small = std::min(ax, ay), large = std::max(ax, ay);
  if (!(large > 0)) return 0;
  constexpr double kTanPi8 = 0.41421356237309503;
  double angle = small <= kTanPi8 * large ? small_atan(small / large)
                                          : kPi / 4 - small_atan((large - small) / (large + small));
  if (ay > ax) angle = kPi / 2 - angle;
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace

Vec3 closest_point(const Triangle& t, const Vec3& p) {
  const Vec3 normal = area_vector(t);
  const double area_sq = norm_sq(normal), flat = kFlat * longest_edge_sq(t);
  if (area_sq > flat * flat && projects_inside(t, normal, p))
    return p - (dot(p - t[0], normal) / area_sq) * normal;
  Vec3 best = closest_on_segment(t[0], t[1], p);
  for (int i = 1; i < 3; ++i) {
    const Vec3 q = closest_on_segment(t[i], t[(i + 1) % 3], p);
    if (dist_sq(p, q) < dist_sq(p, best)) best = q;
  }
  return best;
}

double closest_point_slack(const Triangle& t) {
  const double length_sq = longest_edge_sq(t);
  if (!(length_sq > 0)) return 16 * kEpsilon;
  const double flatness = norm(area_vector(t)) / length_sq;  // height / longest edge
  // The normal's direction errs by a few epsilon / flatness; an edge's nearest point by a few epsilon.
  return 16 * kEpsilon + (flatness > kFlat ? 32 * kEpsilon / flatness : flatness);
}

double winding_of(const Triangle& t, const Vec3& p) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double la = norm(a), lb = norm(b), lc = norm(c);
  // van Oosterom and Strackee 1983: tan(angle / 2).
  const double num = dot(a, cross(b, c));
  const double den = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return angle_of(num, den) / (2 * kPi);
}

}  // namespace unsliver::geom
