#include "second_nearest.hpp"

#include <algorithm>

namespace unsliver::cli {
namespace {

int longest_axis(const Vec3* begin, const Vec3* end) {
  Box3 box;
  for (const Vec3* p = begin; p != end; ++p) box.extend(*p);
  const Vec3 side = box.size();
  if (side.x >= std::max(side.y, side.z)) return 0;
  return side.y >= side.z ? 1 : 2;
}

}  // namespace

SecondNearest::SecondNearest(std::vector<Vec3> points) : points_(std::move(points)) {
  std::sort(points_.begin(), points_.end(), lex_less);
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  axes_.resize(points_.size());
  build(0, points_.size());
}

void SecondNearest::build(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  Vec3* const points = points_.data();
  const int axis = longest_axis(points + begin, points + end);
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(points + begin, points + middle, points + end,
                   [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  axes_[middle] = static_cast<std::uint8_t>(axis);
  build(begin, middle);
  build(middle + 1, end);
}

double SecondNearest::distance(const Vec3& p) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Found found{kInfinity, kInfinity};
  search(0, points_.size(), p, found);
  return std::sqrt(found.second_sq);
}

void SecondNearest::search(std::size_t begin, std::size_t end, const Vec3& p, Found& found) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const double d = dist_sq(p, points_[middle]);
  if (d < found.first_sq)
    found = {d, found.first_sq};
  else if (d < found.second_sq)
    found.second_sq = d;
  const double beyond = p[axes_[middle]] - points_[middle][axes_[middle]];
  const bool left_first = beyond < 0;
  left_first ? search(begin, middle, p, found) : search(middle + 1, end, p, found);
  if (beyond * beyond > found.second_sq) return;
  left_first ? search(middle + 1, end, p, found) : search(begin, middle, p, found);
}

}  // namespace unsliver::cli
