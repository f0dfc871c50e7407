#include "lattice/parents.hpp"

#include <cmath>

namespace unsliver::lattice {
namespace {

Vec3 along(int axis, double length) {
  Vec3 v;
  v[axis] = length;
  return v;
}

/// The direction of the edge, or the normal of the face, whose middle v is: the axis along which v's
/// multiples of the spacing differ in parity from the two others.
int distinguished_axis(const Vec3& v, double spacing) {
  bool odd[3];
  for (int axis = 0; axis < 3; ++axis) odd[axis] = std::fmod(v[axis] / spacing, 2) != 0;
  return odd[1] == odd[2] ? 0 : odd[0] == odd[2] ? 1 : 2;
}

void sort_unique(std::vector<Vec3>& points) {
  std::sort(points.begin(), points.end(), lex_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

}  // namespace

Parents::Parents(const Vec3& v) {
  const Level level = canonical_level(v);
  const double step = power_of_two(region_exponent(level));
  if (is_bcc(level)) {
    for (int i = 0; i < 8; ++i)
      add(v + Vec3{i & 1 ? step : -step, i & 2 ? step : -step, i & 4 ? step : -step});
    return;
  }
  const int axis = distinguished_axis(v, step);
  const Vec3 other = along((axis + 1) % 3, step), third = along((axis + 2) % 3, step);
  for (const double sign : {-1.0, 1.0}) {
    add(v + along(axis, sign * step));
    add(v + sign * (other + third));
    add(v + sign * (other - third));
  }
}

// Parents are coarser than their child: one sweep from the finest level upwards meets every point once.
std::vector<Vec3> closure(std::span<const Vec3> points, Level coarsest) {
  std::vector<std::vector<Vec3>> by_level(kMaxLevel + 1);
  for (const Vec3& p : points) by_level[std::size_t(canonical_level(p))].push_back(p);
  std::vector<Vec3> all;
  for (Level level = kMinLevel; level <= kMaxLevel; ++level) {
    std::vector<Vec3>& here = by_level[std::size_t(level)];
    sort_unique(here);
    if (level < coarsest)
      for (const Vec3& p : here)
        for (const Vec3& q : Parents(p)) by_level[std::size_t(canonical_level(q))].push_back(q);
    all.insert(all.end(), here.begin(), here.end());
    here = {};
  }
  std::sort(all.begin(), all.end(), lex_less);
  return all;
}

}  // namespace unsliver::lattice
