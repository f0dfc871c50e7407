#include <fmt/format.h>

#include "domain/ranges.hpp"
#include "geom/triangle_orient.hpp"
#include "geom/triangle_shape.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

bool holds(const Tet& t, const Vec3& p) {
  const int orientation = geom::exact_orient3d(t[0], t[1], t[2], t[3]);
  for (int i = 0; i < 4; ++i) {
    Tet moved = t;
    moved[i] = p;
    if (geom::exact_orient3d(moved[0], moved[1], moved[2], moved[3]) * orientation < 0) return false;
  }
  return true;
}

/// A lower bound of the distance from p, outside t, to t.
double distance_to_faces(const Tet& t, const Vec3& p) {
  double distance = std::numeric_limits<double>::infinity();
  const double size = norm(bounding_box(t).size());
  for (int i = 0; i < 4; ++i) {
    const geom::Triangle face{t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]};
    const double to_face = dist(p, geom::closest_point(face, p));
    distance = std::min(distance, to_face - 2 * geom::closest_point_slack(face) * (size + to_face));
  }
  return distance;
}

class BallDomain final : public Domain {
 public:
  BallDomain(const Vec3& center, double radius) : center_(center), radius_(radius) {}

  Box3 bounds() const override {
    Box3 box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lo[axis] = std::nextafter(center_[axis] - radius_, -std::numeric_limits<double>::infinity());
      box.hi[axis] = std::nextafter(center_[axis] + radius_, std::numeric_limits<double>::infinity());
    }
    return box;
  }
  bool contains(const Vec3& p) const override { return dist_sq(p, center_) <= radius_ * radius_; }
  double clearance(const Vec3& p) const override {
    const double distance = dist(p, center_), rounding = 4 * kEpsilon * (distance + radius_);
    const double excess = distance - radius_;
    if (std::abs(excess) <= rounding) return 0;
    return excess > 0 ? excess - rounding : excess + rounding;
  }
  /// Is t beyond the plane that touches the ball on its way to the mean of t's corners?
  bool plainly_outside(const Tet& t) const override {
    const Vec3 normal = t[0] + t[1] + t[2] + t[3] - 4 * center_;
    double nearest = std::numeric_limits<double>::infinity(), farthest_sq = 0;
    for (const Vec3& p : t) {
      nearest = std::min(nearest, dot(normal, p - center_));
      farthest_sq = std::max(farthest_sq, dist_sq(p, center_));
    }
    return nearest > norm(normal) * (radius_ + 8 * kEpsilon * std::sqrt(farthest_sq));
  }
  bool meets(const Tet& t) const override {
    const double certain_sq = radius_ * radius_ * (1 - 8 * kEpsilon);
    for (const Vec3& p : t)
      if (dist_sq(p, center_) < certain_sq) return true;
    return holds(t, center_) || distance_to_faces(t, center_) < radius_;
  }
  double volume() const override { return 4.1887902047863905 * radius_ * radius_ * radius_; }
  std::string describe() const override {
    return fmt::format("ball, centre {}, radius {}", domain::format_point(center_), radius_);
  }

 private:
  Vec3 center_;
  double radius_;
};

}  // namespace

DomainPtr make_ball(const Vec3& center, double radius) {
  if (!is_finite(center) || !(radius > 0) || !std::isfinite(radius))
    throw Error(
        ErrorCode::kBadInput,
        fmt::format("a ball needs a finite centre and a finite radius above 0, not centre {} and radius {}",
                    domain::format_point(center), radius));
  auto ball = std::make_shared<BallDomain>(center, radius);
  domain::require_usable_range(ball->bounds(), "the ball");
  return ball;
}

}  // namespace unsliver
