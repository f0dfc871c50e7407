#include "io/point_checks.hpp"

#include "io/fail.hpp"

namespace unsliver::io {

void require_points(const PointSet& set, const std::string& name) {
  if (set.points.empty()) fail(ErrorCode::kBadInput, "{}: the file has no points", name);
  if (set.points.size() >= kNoVertex)
    fail(ErrorCode::kLimit, "{}: {} points are more than a mesh can number", name, set.points.size());
}

double to_size(const Scanner& scanner, std::string_view word, std::string_view what) {
  const double size = scanner.to_number(word, what);
  if (!(size > 0))
    scanner.fail_here(
        ErrorCode::kBadInput,
        fmt::format("{} is {}, but a size must be positive; give one, or leave the point out", what, size));
  return size;
}

}  // namespace unsliver::io
