#include "geom/expression.hpp"

#include <fmt/format.h>

#include "sizing/bound_search.hpp"
#include "sizing/checks.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

constexpr double kSearchTolerance = 0.02;
constexpr int kSearchParts = 2048;

double gradient_bound(const geom::Expression& f, const Box3& box) {
  const geom::Dual d = f.enclosure_over(box);
  return d.value.may_be_nan ? geom::kInfinity : d.steepness;
}

double gradient_at_center(const geom::Expression& f, const Box3& box) {
  const double g = gradient_bound(f, {box.center(), box.center()});
  return std::isfinite(g) ? g * (1 - 1e-9) : 0;
}

/// The axis along which the function may change most over the box.
int most_variable_axis(const geom::Expression& f, const Box3& box) {
  const geom::Dual d = f.enclosure_over(box);
  const auto change = [&](int axis) {
    const double slope = std::fmin(d.slope[static_cast<std::size_t>(axis)].magnitude(), 1e100);
    return slope * (box.hi[axis] - box.lo[axis]);
  };
  const int first = change(1) > change(0) ? 1 : 0;
  return change(2) > change(first) ? 2 : first;
}

double steepest_over(const geom::Expression& f, const Box3& bounds) {
  return sizing::upper_bound(
      bounds, [&f](const Box3& b) { return gradient_bound(f, b); },
      [&f](const Box3& b) { return gradient_at_center(f, b); },
      [&f](const Box3& b) { return most_variable_axis(f, b); }, kSearchTolerance, kSearchParts);
}

double least_value_over(const geom::Expression& f, const Box3& bounds) {
  const auto negative_value = [&f](const Box3& b) {
    const double v = f.at(b.center());
    return std::isnan(v) ? -geom::kInfinity : -v;
  };
  return -sizing::upper_bound(
      bounds, [&f](const Box3& b) { return -f.tight_over(b).lo; }, negative_value,
      [&f](const Box3& b) { return most_variable_axis(f, b); }, kSearchTolerance, kSearchParts);
}

/// Constant along rays that leave `bounds` at right angles: the projection to a box never lengthens a
/// distance, so whatever holds inside (positive, Lipschitz) holds in all of space.
class ExpressionSize final : public Sizing {
 public:
  ExpressionSize(const std::string& text, const Box3& bounds)
      : f_(geom::Expression::parse(text)),
        bounds_(bounds),
        lipschitz_(steepest_over(f_, bounds)),
        least_(std::max(least_value_over(f_, bounds), std::numeric_limits<double>::min())) {}

  double at(const Vec3& p) const override {
    const Vec3 q = sizing::clamped(p, bounds_);
    const double s = f_.at(q);
    return s > 0 ? s : sizing::checked_size(s, q, describe());
  }

  double lower_bound(const Box3& box) const override {
    return std::max(f_.tight_over(sizing::clamped(box, bounds_)).lo, least_);
  }

  double lipschitz() const override { return lipschitz_; }
  double lipschitz_over(const Box3& box) const override {
    return std::min(lipschitz_, gradient_bound(f_, sizing::clamped(box, bounds_)));
  }
  std::string describe() const override { return fmt::format("expression {}", f_.text()); }

  std::vector<std::string> notes() const override {
    std::vector<std::string> all;
    all.push_back(
        fmt::format("outside {} the size is that of the nearest point inside", sizing::to_text(bounds_)));
    if (!std::isfinite(lipschitz_)) {
      all.push_back("no bound on the gradient of the size was found: it may jump or be infinitely steep");
    }
    if (least_ == std::numeric_limits<double>::min()) {
      all.push_back("the size could not be proved positive everywhere in its bounds");
    }
    return all;
  }

 private:
  geom::Expression f_;
  Box3 bounds_;
  double lipschitz_, least_;
};

}  // namespace

SizingPtr expression_size(const std::string& expression, const Box3& bounds) {
  sizing::require_bounds(bounds);
  return std::make_shared<ExpressionSize>(expression, bounds);
}

}  // namespace unsliver
