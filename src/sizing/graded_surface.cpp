#include <fmt/format.h>

#include "geom/triangle_tree.hpp"
#include "sizing/checks.hpp"
#include "unsliver/error.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

/// Rounding errors of distances, relative to the largest coordinate in play.
constexpr double kDistanceSlack = 1e-13;

struct Grading {
  double h0, gradation, cap;

  double at_distance(double d) const { return std::min(cap, h0 + gradation * d); }
  /// Farther than this from the surface the cap rules.
  double reach() const {
    return gradation > 0 ? (cap - h0) / gradation * (1 + 1e-9) : std::numeric_limits<double>::infinity();
  }
};

class GradedFromSurface final : public Sizing {
 public:
  GradedFromSurface(const TriangleMesh& surface, const Grading& grading) : tree_(surface), grading_(grading) {
    for (const Vec3& p : surface.points) {
      extent_ = std::max({extent_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    name_ = surface.name.empty() ? "the surface" : surface.name;
  }

  double at(const Vec3& p) const override {
    if (grading_.gradation == 0) return grading_.h0;
    return grading_.at_distance(tree_.nearest(p, grading_.reach()).distance);
  }

  double lower_bound(const Box3& box) const override {
    const double coordinate = std::max({extent_, norm(box.lo), norm(box.hi)});
    const double nearest = tree_.nearest(box.center(), grading_.reach() + box.diagonal()).distance;
    const double d = nearest - 0.5 * box.diagonal() - kDistanceSlack * coordinate;
    return grading_.at_distance(std::max(0.0, d));
  }

  double lipschitz() const override { return grading_.gradation; }

  std::string describe() const override {
    return fmt::format("{} at {}, gradation {}, at most {}", grading_.h0, name_, grading_.gradation,
                       grading_.cap);
  }

 private:
  geom::TriangleTree tree_;
  Grading grading_;
  double extent_ = 0;
  std::string name_;
};

void check_surface(const TriangleMesh& surface) {
  if (surface.triangles.empty()) {
    throw Error(ErrorCode::kBadInput, "The surface to grade the size from has no triangles.");
  }
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    if (is_finite(surface.points[i])) continue;
    Error error(
        ErrorCode::kBadInput,
        fmt::format("Point {} of the surface to grade the size from is {}; coordinates must be finite.", i,
                    sizing::to_text(surface.points[i])));
    error.ids.push_back(static_cast<std::int64_t>(i));
    throw error;
  }
}

}  // namespace

SizingPtr graded_from_surface(const TriangleMesh& surface, double h0, double gradation, double cap) {
  sizing::require_positive(h0, "The size at the surface");
  sizing::require_grading(gradation, cap);
  if (cap < h0) {
    throw Error(
        ErrorCode::kBadOption,
        fmt::format("The largest size {} is below the size at the surface {}; swap or raise it.", cap, h0));
  }
  check_surface(surface);
  return std::make_shared<GradedFromSurface>(surface, Grading{h0, gradation, cap});
}

}  // namespace unsliver
