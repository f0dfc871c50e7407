#include <fmt/format.h>

#include <optional>

#include "domain/ranges.hpp"
#include "domain/tet_box.hpp"
#include "geom/expression.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

/// The volume is estimated, and an inside point looked for, at the centres of kSamples^3 cells.
constexpr int kSamples = 48;
/// Boxes looked at before a search for an inside point is given up.
constexpr int kMostSearchBoxes = 100000;
/// Boxes looked at before a tetrahedron is kept for safety.
constexpr int kMostBoxes = 256;
/// A part of a tetrahedron's box this much smaller than the whole is not cut further.
constexpr double kSmallestPart = 1.0 / 16;

std::array<Box3, 2> halves(const Box3& box) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (box.size()[k] > box.size()[axis]) axis = k;
  std::array<Box3, 2> parts{box, box};
  parts[0].hi[axis] = parts[1].lo[axis] = box.center()[axis];
  return parts;
}

Box3 common_part(const Box3& a, const Box3& b) {
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = std::max(a.lo[axis], b.lo[axis]);
    box.hi[axis] = std::min(a.hi[axis], b.hi[axis]);
  }
  return box;
}

/// {f <= 0} within a box; where f is NaN is outside.
class ImplicitDomain final : public Domain {
 public:
  ImplicitDomain(geom::Expression f, const Box3& bounds) : f_(std::move(f)), bounds_(bounds) {
    int inside = 0;
    const Vec3 step = (1.0 / kSamples) * bounds.size();
    for (int z = 0; z < kSamples; ++z)
      for (int y = 0; y < kSamples; ++y)
        for (int x = 0; x < kSamples; ++x)
          inside += contains(bounds.lo + Vec3{(x + 0.5) * step.x, (y + 0.5) * step.y, (z + 0.5) * step.z});
    const Vec3 side = bounds.size();
    volume_ = side.x * side.y * side.z * inside / (1.0 * kSamples * kSamples * kSamples);
    if (inside == 0 && !has_inside_point()) throw nothing_inside();
  }

  Box3 bounds() const override { return bounds_; }
  bool contains(const Vec3& p) const override { return bounds_.contains(p) && f_.at(p) <= 0; }

  double clearance(const Vec3& p) const override {
    if (!bounds_.contains(p)) return domain::distance_to_box(p, bounds_);
    const double value = f_.at(p);
    if (std::isnan(value)) return 0;
    const double radius = constant_sign_radius(p, value);
    return value > 0 ? radius : -std::min(radius, domain::depth_in_box(p, bounds_));
  }

  /// One look at the ball's box, where `clearance` needs several.
  int side_of_ball(const Vec3& p, double radius) const override {
    const double reach = radius + 4 * std::numeric_limits<double>::epsilon() * (norm(p) + radius);
    const Box3 box{p - Vec3{reach, reach, reach}, p + Vec3{reach, reach, reach}};
    const Box3 inner = common_part(box, bounds_);
    if (inner.empty()) return 1;
    const geom::Interval f = signed_over(inner);
    if (f.lo > 0) return 1;
    return f.hi <= 0 && !f.may_be_nan && bounds_.contains(box.lo) && bounds_.contains(box.hi) ? -1 : 0;
  }

  bool meets(const Tet& t) const override {
    if (!domain::interior_meets_box(t, bounds_)) return false;
    if (contains(domain::centroid(t)) ||
        std::any_of(t.begin(), t.end(), [&](const Vec3& p) { return contains(p); }))
      return true;
    const Box3 whole = common_part(bounding_box(t), bounds_);
    std::vector<Box3> pending{whole};
    for (int looked = 0; !pending.empty(); ++looked) {
      if (looked == kMostBoxes) return true;
      const Box3 box = pending.back();
      pending.pop_back();
      if (signed_over(box).lo > 0 || !domain::interior_meets_box(t, box)) continue;
      if (box.longest_side() <= kSmallestPart * whole.longest_side()) return true;
      for (const Box3& half : halves(box)) pending.push_back(half);
    }
    return false;
  }

  double volume() const override { return volume_; }
  std::string describe() const override {
    return fmt::format("implicit, {} <= 0 in {} to {}", f_.text(), domain::format_point(bounds_.lo),
                       domain::format_point(bounds_.hi));
  }
  std::vector<std::string> notes() const override {
    return {fmt::format("volume is estimated at {}^3 samples; coverage is sound, by interval arithmetic",
                        kSamples)};
  }

 private:
  /// f over a box, tight only where the plain bounds leave its sign open.
  geom::Interval signed_over(const Box3& box) const {
    const geom::Interval plain = f_.over(box);
    return plain.lo > 0 || plain.hi <= 0 ? plain : f_.tight_over(box);
  }

  /// r such that f keeps the sign of `value` = f(p) in the open ball: |f(q) - f(p)| <= |slope| |q - p| +
  /// rounding.
  double constant_sign_radius(const Vec3& p, double value) const {
    double best = 0;
    for (double side = 0.5 * bounds_.diagonal(); side > best; side *= 0.25) {
      const geom::Dual f = f_.enclosure_over({p - Vec3{side, side, side}, p + Vec3{side, side, side}});
      if (f.value.may_be_nan) continue;
      const bool constant = value > 0 ? f.value.lo > 0 : f.value.hi <= 0;
      const Vec3 slope{f.slope[0].magnitude(), f.slope[1].magnitude(), f.slope[2].magnitude()};
      const double reach = (1 - 1e-12) * (std::abs(value) - 2 * f.rounding) / norm(slope);
      const double radius = constant || reach > side ? side : reach;
      if (radius > best) best = radius;
      if (side < 1e-9 * bounds_.diagonal()) break;
    }
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * norm(p);  // of the boxes' corners
    return std::max(0.0, best * (1 - 1e-12) - rounding);
  }

  /// Breadth first where f may be <= 0, at centres.
  bool has_inside_point() const {
    std::vector<Box3> boxes{bounds_};
    for (std::size_t next = 0; next < boxes.size() && next < kMostSearchBoxes; ++next) {
      const Box3 box = boxes[next];
      if (contains(box.center())) return true;
      if (f_.tight_over(box).lo > 0) continue;
      for (const Box3& half : halves(box)) boxes.push_back(half);
    }
    return false;
  }

  Error nothing_inside() const {
    const Vec3 middle = bounds_.center();
    return Error(
        ErrorCode::kBadInput,
        fmt::format("no point with {} <= 0 was found in {} to {} (it is {} at the centre); inside is where "
                    "the formula is negative: check its sign and the bounds",
                    f_.text(), domain::format_point(bounds_.lo), domain::format_point(bounds_.hi),
                    f_.at(middle)));
  }

  geom::Expression f_;
  Box3 bounds_;
  double volume_ = 0;
};

}  // namespace

DomainPtr make_implicit(const std::string& expression, const Box3& bounds) {
  geom::Expression f = geom::Expression::parse(expression);
  make_box(bounds);  // the same demands, and the same words
  return std::make_shared<ImplicitDomain>(std::move(f), bounds);
}

}  // namespace unsliver
