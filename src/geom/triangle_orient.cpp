#include "geom/triangle_orient.hpp"

#include <array>
#include <cmath>

namespace unsliver::geom {
namespace {

/// 2^-52, the spacing of doubles at 1; rounding errs by at most half of it, relatively.
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

int sign_of(double x) { return (x > 0) - (x < 0); }

/// high + low = the exact value of a sum, a difference or a product.
struct TwoTerms {
  double high = 0, low = 0;
};

TwoTerms exact_sum(double a, double b) {
  const double high = a + b;
  const double b_seen = high - a;
  return {high, (a - (high - b_seen)) + (b - b_seen)};
}

TwoTerms exact_difference(double a, double b) { return exact_sum(a, -b); }

TwoTerms exact_product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

/// An unevaluated sum of doubles of increasing magnitude that do not overlap (Shewchuk 1997, grow-expansion):
/// its sign is the sign of its last term.
class ExactSum {
 public:
  void add(double x) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      const TwoTerms sum = exact_sum(x, terms_[i]);
      x = sum.high;
      if (sum.low != 0) terms_[kept++] = sum.low;
    }
    if (x != 0) terms_[kept++] = x;
    count_ = kept;
  }

  void add_product(double a, double b) {
    const TwoTerms ab = exact_product(a, b);
    add(ab.low);
    add(ab.high);
  }

  void add_product(double a, double b, double c) {
    if (a == 0 || b == 0 || c == 0) return;
    const TwoTerms ab = exact_product(a, b);
    add_product(ab.low, c);
    add_product(ab.high, c);
  }

  int sign() const { return count_ == 0 ? 0 : sign_of(terms_[count_ - 1]); }

 private:
  /// det of 3x3: 6 signed products of three two-term factors, 8 combinations of terms, 4 doubles each.
  static constexpr int kMostTerms = 6 * 8 * 4;
  std::array<double, kMostTerms> terms_;
  int count_ = 0;
};

void add_product(ExactSum& sum, const TwoTerms& a, const TwoTerms& b, const TwoTerms& c, double sign) {
  for (const double x : {a.low, a.high})
    for (const double y : {b.low, b.high})
      for (const double z : {c.low, c.high}) sum.add_product(sign * x, y, z);
}

using ExactVec3 = std::array<TwoTerms, 3>;

ExactVec3 exact_difference(const Vec3& a, const Vec3& b) {
  return {exact_difference(a.x, b.x), exact_difference(a.y, b.y), exact_difference(a.z, b.z)};
}

int exact_det_sign(const ExactVec3& r, const ExactVec3& s, const ExactVec3& t) {
  ExactSum sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    add_product(sum, r[i], s[j], t[k], 1);
    add_product(sum, r[i], s[k], t[j], -1);
  }
  return sum.sign();
}

}  // namespace

int exact_det(const ExactStep& first, const ExactStep& second, const ExactStep& third) {
  const Vec3 r = first.to - first.from, s = second.to - second.from, t = third.to - third.from;
  const double m1 = s.y * t.z, m2 = s.z * t.y, m3 = s.z * t.x, m4 = s.x * t.z, m5 = s.x * t.y, m6 = s.y * t.x;
  const double det = r.x * (m1 - m2) + r.y * (m3 - m4) + r.z * (m5 - m6);
  const double size = std::abs(r.x) * (std::abs(m1) + std::abs(m2)) +
                      std::abs(r.y) * (std::abs(m3) + std::abs(m4)) +
                      std::abs(r.z) * (std::abs(m5) + std::abs(m6));
  // Each of the six products carries at most 8 roundings (3 differences, 2 products, 3 sums) of half an
  // epsilon.
  if (std::abs(det) > 5 * kEpsilon * size) return sign_of(det);
  if (size == 0) return 0;
  return exact_det_sign(exact_difference(first.to, first.from), exact_difference(second.to, second.from),
                        exact_difference(third.to, third.from));
}

int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return exact_det({a, b}, {a, c}, {a, d});
}

int exact_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int u, int v) {
  const double left = (b[u] - a[u]) * (c[v] - a[v]), right = (b[v] - a[v]) * (c[u] - a[u]);
  // Each product carries at most 4 roundings.
  if (std::abs(left - right) > 3 * kEpsilon * (std::abs(left) + std::abs(right)))
    return sign_of(left - right);
  const TwoTerms one{1, 0};
  ExactSum sum;
  add_product(sum, exact_difference(b[u], a[u]), exact_difference(c[v], a[v]), one, 1);
  add_product(sum, exact_difference(b[v], a[v]), exact_difference(c[u], a[u]), one, -1);
  return sum.sign();
}

}  // namespace unsliver::geom
