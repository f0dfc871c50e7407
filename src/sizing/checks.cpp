#include "sizing/checks.hpp"

#include <fmt/format.h>

#include "unsliver/error.hpp"

namespace unsliver::sizing {

std::string to_text(const Vec3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

std::string to_text(const Box3& box) { return fmt::format("{} to {}", to_text(box.lo), to_text(box.hi)); }

double checked_size(double s, const Vec3& p, std::string_view origin) {
  if (s > 0) return s;
  Error error(ErrorCode::kBadInput,
              fmt::format("The size at {} is {}, but a size must be greater than 0 ({}). Change the sizing "
                          "function so that it is positive everywhere in the domain.",
                          to_text(p), s, origin));
  error.places.push_back(p);
  throw error;
}

void require_positive(double value, std::string_view name) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(ErrorCode::kBadOption,
              fmt::format("{} is {}, but it must be finite and greater than 0.", name, value));
}

void require_grading(double gradation, double cap) {
  if (!(gradation >= 0 && std::isfinite(gradation))) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("The gradation is {}, but it must be finite and at least 0.", gradation));
  }
  if (!(cap > 0)) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("The largest size is {}, but it must be greater than 0.", cap));
  }
}

void require_bounds(const Box3& bounds) {
  const Vec3 size = bounds.size();
  if (is_finite(bounds.lo) && is_finite(bounds.hi) && is_finite(size) && size.x > 0 && size.y > 0 &&
      size.z > 0)
    return;
  throw Error(
      ErrorCode::kBadInput,
      fmt::format("The bounds of the sizing function are {}; they must be finite with positive sides.",
                  to_text(bounds)));
}

Vec3 clamped(const Vec3& p, const Box3& box) {
  Vec3 q;
  for (int axis = 0; axis < 3; ++axis) q[axis] = std::clamp(p[axis], box.lo[axis], box.hi[axis]);
  return q;
}

Box3 clamped(const Box3& box, const Box3& bounds) {
  return {clamped(box.lo, bounds), clamped(box.hi, bounds)};
}

Box3 inflated(const Box3& box, double margin) {
  const Vec3 m{margin, margin, margin};
  return {box.lo - m, box.hi + m};
}

}  // namespace unsliver::sizing
