#include "geom/point_tree.hpp"

#include <algorithm>
#include <numeric>

namespace unsliver::geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int longest_axis(const Vec3& size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Half the side of a cube that holds every point whose computed squared distance is at most radius_sq: such
/// a distance is short of the true one by less than a relative 2^-51, and subtraction rounds monotonically.
double half_side_around(double radius_sq) { return std::sqrt(radius_sq) * (1 + 0x1p-49); }

}  // namespace

/// What the queries about balls share: the nearer half of a node comes first.
struct PointTree::BallQuery {
  BallQuery(const PointTree& tree, const Vec3& w, double radius_sq)
      : center(w),
        by_axis{w.x, w.y, w.z},
        within_sq(radius_sq),
        points(tree.points_),
        cube(w, half_side_around(radius_sq)) {}

  bool right_first(const Cut& cut) const {
    const double c = by_axis[cut.axis];
    return cut.right_min - c < c - cut.left_max;
  }

  Vec3 center;
  std::array<double, 3> by_axis;
  double within_sq;
  std::span<const Vec3> points;
  Cube cube;
};

struct PointTree::TwoNearestQuery : BallQuery {
  using BallQuery::BallQuery;

  bool visit(std::size_t from, std::size_t to) {
    const double before = found.second_sq;
    for (; from < to; ++from) {
      const double d = dist_sq(points[from], center);
      found.second_sq = std::min(found.second_sq, std::max(found.first_sq, d));
      found.first_sq = std::min(found.first_sq, d);
    }
    if (found.second_sq < std::min(before, within_sq)) cube = Cube(center, half_side_around(found.second_sq));
    return false;
  }

  TwoNearest found{kInfinity, kInfinity};
};

struct PointTree::CountQuery : BallQuery {
  CountQuery(const BallQuery& ball, std::size_t count) : BallQuery(ball), missing(count) {}

  bool visit(std::size_t from, std::size_t to) {
    for (; from < to && missing > 0; ++from)
      if (dist_sq(points[from], center) <= within_sq) --missing;
    return missing == 0;
  }

  std::size_t missing;
};

PointTree::PointTree(std::span<const Vec3> points) : points_(points.size()), ids_(points.size()) {
  std::iota(ids_.begin(), ids_.end(), VertexId{0});
  while (points.size() >> depth_ > kLeafSize) ++depth_;
  cuts_.resize(std::size_t{1} << depth_);
  build(1, 0, points);
  for (std::size_t i = 0; i < ids_.size(); ++i) points_[i] = points[ids_[i]];
}

std::size_t PointTree::bytes() const {
  return cuts_.capacity() * sizeof(Cut) + points_.capacity() * sizeof(Vec3) +
         ids_.capacity() * sizeof(VertexId);
}

// Splits at the median along the longest side. The orders are total, so the halves are the same whatever the
// library's selection does.
void PointTree::build(std::size_t node, int depth, std::span<const Vec3> points) {
  const std::size_t index = node - (std::size_t{1} << depth);
  const auto at = [&](std::size_t i, int d) { return ids_.begin() + std::ptrdiff_t(first_of(i, d)); };
  const auto first = at(index, depth), last = at(index + 1, depth);
  const auto lex_before = [&](VertexId a, VertexId b) {
    return points[a] == points[b] ? a < b : lex_less(points[a], points[b]);
  };
  if (depth == depth_) {
    std::sort(first, last, lex_before);
    return;
  }
  Box3 box;
  for (auto id = first; id != last; ++id) box.extend(points[*id]);
  const int axis = longest_axis(box.size());
  const auto middle = at(2 * index + 1, depth + 1);
  std::nth_element(first, middle, last, [&](VertexId a, VertexId b) {
    return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : lex_before(a, b);
  });
  double left_max = -kInfinity;
  for (auto id = first; id != middle; ++id) left_max = std::max(left_max, points[*id][axis]);
  cuts_[node] = {left_max, points[*middle][axis], axis};
  build(2 * node, depth + 1, points);
  build(2 * node + 1, depth + 1, points);
}

PointTree::TwoNearest PointTree::two_nearest(const Vec3& w, double within_sq) const {
  TwoNearestQuery query(*this, w, within_sq);
  walk(query);
  const auto or_none = [&](double d) { return d <= within_sq ? d : kInfinity; };
  return {or_none(query.found.first_sq), or_none(query.found.second_sq)};
}

bool PointTree::has_within(const Vec3& w, double radius, std::size_t count) const {
  CountQuery query(BallQuery(*this, w, radius * radius), count);
  if (count > 0) walk(query);
  return query.missing == 0;
}

bool PointTree::has_in_cube(const Vec3& center, double half) const {
  bool found = false;
  visit_cube(center, half, [&](VertexId, const Vec3&) { return found = true; });
  return found;
}

VertexId PointTree::first_in_cube(const Vec3& center, double half) const {
  VertexId best = kNoVertex;
  Vec3 best_point;
  visit_cube(center, half, [&](VertexId id, const Vec3& point) {
    if (best == kNoVertex || lex_less(point, best_point)) best = id, best_point = point;
    return false;
  });
  return best;
}

}  // namespace unsliver::geom
