#include <fmt/format.h>

#include "base/plural.hpp"
#include "sizing/checks.hpp"
#include "sizing/cone_field.hpp"
#include "unsliver/error.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

class GradedFromPoints final : public Sizing {
 public:
  GradedFromPoints(sizing::ConeField cones, double gradation, double cap)
      : cones_(std::move(cones)), gradation_(gradation), cap_(cap) {}

  double at(const Vec3& p) const override { return cones_.at(p, cap_); }
  double lower_bound(const Box3& box) const override { return cones_.least_over(box, cap_); }
  double lipschitz() const override { return gradation_; }

  std::string describe() const override {
    return fmt::format("graded from {}, gradation {}, at most {}", plural(cones_.size(), "point", "points"),
                       gradation_, cap_);
  }

 private:
  sizing::ConeField cones_;
  double gradation_, cap_;
};

Error at_point(std::size_t i, const Vec3& p, const std::string& fault) {
  Error error(ErrorCode::kBadInput, fmt::format("Sizing point {} at {}: {}.", i, sizing::to_text(p), fault));
  error.ids.push_back(static_cast<std::int64_t>(i));
  error.places.push_back(p);
  return error;
}

void check_points(const std::vector<Vec3>& points, const std::vector<double>& h0) {
  if (points.empty()) {
    throw Error(ErrorCode::kBadInput, "No points were given to grade the size from; give at least one.");
  }
  if (h0.size() != 1 && h0.size() != points.size()) {
    throw Error(ErrorCode::kBadInput,
                fmt::format("{} sizes were given for {} points; give one, or one a point.", h0.size(),
                            points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) throw at_point(i, points[i], "the coordinates must be finite");
    const double h = h0.size() == 1 ? h0[0] : h0[i];
    if (!(h > 0 && std::isfinite(h))) {
      throw at_point(i, points[i], fmt::format("its size is {}, but it must be finite and above 0", h));
    }
  }
}

}  // namespace

SizingPtr graded_from_points(std::vector<Vec3> points, std::vector<double> h0, double gradation, double cap) {
  sizing::require_grading(gradation, cap);
  check_points(points, h0);
  if (h0.size() == 1) h0.resize(points.size(), h0[0]);
  std::vector<Box3> boxes;
  boxes.reserve(points.size());
  for (const Vec3& p : points) boxes.push_back({p, p});
  return std::make_shared<GradedFromPoints>(sizing::ConeField(std::move(boxes), std::move(h0), gradation),
                                            gradation, cap);
}

}  // namespace unsliver
