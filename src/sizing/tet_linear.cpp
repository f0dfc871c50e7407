#include "sizing/tet_linear.hpp"

namespace unsliver::sizing {
namespace {

/// Below this flatness rounding may spoil the gradient, and only corner values bound the function.
constexpr double kTrustedFlatness = 1e-6;
constexpr double kSlack = 1e-8;

/// The most that a linear function can change from the centre of a box to any of its points.
double largest_change(const Vec3& gradient, const Box3& box) {
  const Vec3 half = 0.5 * box.size();
  return std::fabs(gradient.x) * half.x + std::fabs(gradient.y) * half.y + std::fabs(gradient.z) * half.z;
}

}  // namespace

TetLinear::TetLinear(const Tet& corners, const std::array<double, 4>& values)
    : corners_(corners), values_(values) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const double volume = dot(cross(a, b), c);
  const double longest = std::sqrt(std::max({norm_sq(a), norm_sq(b), norm_sq(c)}));
  flatness_ = longest > 0 ? std::fabs(volume) / (longest * longest * longest) : 0;
  if (is_flat()) return;
  const double inverse = 1 / volume;
  rows_ = {inverse * cross(b, c), inverse * cross(c, a), inverse * cross(a, b)};
}

std::array<double, 4> TetLinear::coordinates(const Vec3& p) const {
  const Vec3 d = p - corners_[0];
  const double b = dot(rows_[0], d), c = dot(rows_[1], d), e = dot(rows_[2], d);
  return {1 - b - c - e, b, c, e};
}

Vec3 TetLinear::gradient() const {
  Vec3 g;
  for (int i = 0; i < 3; ++i) g = g + (values_[i + 1] - values_[0]) * rows_[i];
  return g;
}

bool TetLinear::may_meet(const Box3& box) const {
  if (flatness_ < kTrustedFlatness) return true;
  const auto at_center = coordinates(box.center());
  const std::array<Vec3, 4> gradients{rows_[0] + rows_[1] + rows_[2], rows_[0], rows_[1], rows_[2]};
  for (int i = 0; i < 4; ++i)
    if (at_center[i] + largest_change(gradients[i], box) < -kSlack) return false;
  return true;
}

double TetLinear::lower_bound(const Box3& box) const {
  const auto [least, most] = std::minmax_element(values_.begin(), values_.end());
  if (flatness_ < kTrustedFlatness) return *least;
  const Vec3 g = gradient();
  const double center = values_[0] + dot(g, box.center() - corners_[0]);
  return std::max(*least, center - largest_change(g, box) - kSlack * *most);
}

std::array<double, 3> triangle_coordinates(const std::array<Vec3, 3>& corners, const Vec3& p) {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area_sq = norm_sq(normal);
  if (area_sq == 0) return {1, 0, 0};
  std::array<double, 3> w;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &u = corners[(i + 1) % 3], &v = corners[(i + 2) % 3];
    w[i] = std::clamp(dot(normal, cross(u - p, v - p)) / area_sq, 0.0, 1.0);
    sum += w[i];
  }
  for (double& weight : w) weight /= sum;
  return w;
}

}  // namespace unsliver::sizing
