// Notation: u, v, w the edges from corner 0; the centre is N / (2 det) away from it, with
// N = |u|^2 v x w + |v|^2 w x u + |w|^2 u x v and det = det(u, v, w).
//
// In doubles, the errors of det and of N are below 3e-15 P and 3e-15 P max(|u|, |v|, |w|), P = |u| |v| |w|,
// and |N| = 2 R |det| >= max(|u|, |v|, |w|) |det|. So |det| >= 3e-5 P leaves a relative error below 2e-10.
#include "refine/circumsphere.hpp"

#include <cmath>

#include "exact/determinants.hpp"
#include "exact/wide_int.hpp"

namespace unsliver::refine {

namespace {

using exact::Int128;
using exact::Int256;
using Edge = exact::Row<std::int64_t>;

constexpr double kLeastShareSq = 9e-10;
constexpr int kDifferenceBits = 49;
static_assert(exact::bit_budget(2, 2, kDifferenceBits) < 128 &&
              exact::bit_budget(3, 2, kDifferenceBits) < 128);
static_assert(exact::bit_budget(18, 4, kDifferenceBits) < Int256::kBits);

Edge edge(const Vec3& from, const Vec3& to) {
  return {std::int64_t(to.x - from.x), std::int64_t(to.y - from.y), std::int64_t(to.z - from.z)};
}

exact::Row<Int128> cross(const Edge& a, const Edge& b) {
  const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return Int128(p) * s - Int128(q) * r;
  };
  return {minor(a.y, a.z, b.y, b.z), minor(a.z, a.x, b.z, b.x), minor(a.x, a.y, b.x, b.y)};
}

double to_double(const Int256& value) {
  const bool negative = value.sign() < 0;
  const Int256 magnitude = negative ? -value : value;
  double sum = 0;
  for (int i = 3; i >= 0; --i) sum += std::ldexp(static_cast<double>(magnitude.word(i)), 64 * i);
  return negative ? -sum : sum;
}

geom::Sphere exact_circumsphere(const Tet& t) {
  const Edge u = edge(t[0], t[1]), v = edge(t[0], t[2]), w = edge(t[0], t[3]);
  const auto vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Int256 lu(exact::lift<Int128>(u)), lv(exact::lift<Int128>(v)), lw(exact::lift<Int128>(w));
  const auto sum = [](const Int256& a, Int128 p, const Int256& b, Int128 q, const Int256& c, Int128 r) {
    return to_double(a * Int256(p) + b * Int256(q) + c * Int256(r));
  };
  const Vec3 n{sum(lu, vw.x, lv, wu.x, lw, uv.x), sum(lu, vw.y, lv, wu.y, lw, uv.y),
               sum(lu, vw.z, lv, wu.z, lw, uv.z)};
  const double det = sum(Int256(u.x), vw.x, Int256(u.y), vw.y, Int256(u.z), vw.z);
  const Vec3 c = 0.5 / det * n;
  return {t[0] + c, norm_sq(c)};
}

}  // namespace

geom::Sphere circumsphere(const Tet& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = t[3] - t[0];
  const double det = dot(u, unsliver::cross(v, w));
  if (det * det < kLeastShareSq * (norm_sq(u) * norm_sq(v) * norm_sq(w))) [[unlikely]]
    return exact_circumsphere(t);
  return geom::circumsphere(t);
}

}  // namespace unsliver::refine
