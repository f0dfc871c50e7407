#include "verify/orientation.hpp"

#include <algorithm>

#include "verify/shape.hpp"

namespace unsliver::verifier {
namespace {

int exact_sign(const std::array<Vec3, 4>& p) {
  int exponent = 0;
  for (const Vec3& q : p) {
    for (int axis = 0; axis < 3; ++axis) exponent = std::min(exponent, decompose(q[axis]).exponent);
  }
  std::array<Row<BigInt>, 3> d;
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      d[i][axis] = scaled(p[i + 1][axis], exponent) - scaled(p[0][axis], exponent);
    }
  }
  return sign(dot(d[0], cross(d[1], d[2])));
}

/// Has a component so small that a product of three may underflow?
bool has_tiny(const Vec3& d) {
  const auto tiny = [](double x) { return x != 0 && std::abs(x) < 1e-100; };
  return tiny(d.x) || tiny(d.y) || tiny(d.z);
}

}  // namespace

int orientation_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, SignCounts& counts) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double vw[6] = {v.y * w.z, v.z * w.y, v.z * w.x, v.x * w.z, v.x * w.y, v.y * w.x};
  const double det = u.x * (vw[0] - vw[1]) + u.y * (vw[2] - vw[3]) + u.z * (vw[4] - vw[5]);
  const double size = std::abs(u.x) * (std::abs(vw[0]) + std::abs(vw[1])) +
                      std::abs(u.y) * (std::abs(vw[2]) + std::abs(vw[3])) +
                      std::abs(u.z) * (std::abs(vw[4]) + std::abs(vw[5]));
  // Each of the six terms has gone through at most nine roundings; `size` itself may be short by as many.
  if (size > 1e-200 && std::abs(det) > 16 * kRoundoff * size) {
    ++counts.filtered;
    return sign(det);
  }
  if (size == 0 && !has_tiny(u) && !has_tiny(v) && !has_tiny(w)) {
    ++counts.filtered;
    return 0;
  }
  ++counts.exact;
  return exact_sign({a, b, c, d});
}

Side locate_in_tet(const Tet& t, const Vec3& p, SignCounts& counts) {
  const int orientation = orientation_sign(t[0], t[1], t[2], t[3], counts);
  if (orientation == 0) return Side::kOutside;
  bool strictly = true;
  for (std::size_t i = 0; i < 4; ++i) {
    Tet part = t;
    part[i] = p;
    const int s = orientation * orientation_sign(part[0], part[1], part[2], part[3], counts);
    if (s < 0) return Side::kOutside;
    strictly &= s > 0;
  }
  return strictly ? Side::kInside : Side::kBoundary;
}

}  // namespace unsliver::verifier
