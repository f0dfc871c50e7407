#include "geom/tetrahedron.hpp"

namespace unsliver::geom {

double shortest_edge_sq(const Tet& t) {
  return std::min({dist_sq(t[0], t[1]), dist_sq(t[0], t[2]), dist_sq(t[0], t[3]), dist_sq(t[1], t[2]),
                   dist_sq(t[1], t[3]), dist_sq(t[2], t[3])});
}

double radius_edge_ratio(const Tet& t) {
  const double ratio_sq = circumsphere(t).radius_sq / shortest_edge_sq(t);
  return std::isnan(ratio_sq) ? std::numeric_limits<double>::infinity() : std::sqrt(ratio_sq);
}

// Let m_i be the normal of the face opposite corner i, pointing inwards, twice the face's area long, and d
// six times the volume. At the edge e between faces k and l, m_k x m_l is d e up to sign, and so
// cot(angle) = -(m_k . m_l) / (|d| |e|): no cancellation where the angle is near 0 or pi.
std::array<double, 6> dihedral_cotangents(const Tet& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = t[3] - t[0];
  const Vec3 uv = v - u, uw = w - u, vw = w - v;
  const Vec3 m0 = cross(uw, uv), m1 = cross(v, w), m2 = cross(w, u), m3 = cross(u, v);
  const double d = std::abs(dot(u, m1));
  const auto cotangent = [d](const Vec3& e, const Vec3& a, const Vec3& b) {
    const double c = -dot(a, b) / (d * norm(e));
    return c == c ? c : std::numeric_limits<double>::infinity();  // 0/0: corners coincide
  };
  return {cotangent(u, m2, m3),  cotangent(v, m1, m3),  cotangent(w, m1, m2),
          cotangent(uv, m0, m3), cotangent(uw, m0, m2), cotangent(vw, m0, m1)};
}

std::array<double, 6> dihedral_angles(const Tet& t) {
  std::array<double, 6> angles = dihedral_cotangents(t);
  for (double& angle : angles) angle = angle_of_cotangent(angle);
  return angles;
}

}  // namespace unsliver::geom
