#include "refine/candidates.hpp"

#include <algorithm>

#include "lattice/ball.hpp"
#include "refine/guarantees.hpp"

namespace unsliver::refine {

namespace {

// Beyond this covering radius, in circumradii, a lattice rarely has a point inside the sphere.
constexpr double kCoarsestRadius = 2.2;
// Points farther than this from the circumcentre, in covering radii, are passed over for nearer ones of a
// finer level.
constexpr double kSearchRadius = 1.5;

std::optional<Vec3> first_in_conflict(Refinement& r, TetId t, const std::vector<Vec3>& points) {
  for (const Vec3& w : points)
    if (r.mesh().corner_at(t, w) == kNoVertex && r.mesh().in_conflict(t, w)) return w;
  return std::nullopt;
}

}  // namespace

double inherited_lfs_bound(const Refinement& r, TetId t, const Vec3& w) {
  double bound = std::numeric_limits<double>::infinity();
  for (VertexId v : r.mesh().tet(t).v) bound = std::min(bound, r.lfs_bound(v) + dist(r.mesh().point(v), w));
  return bound * (1 + 1e-9);
}

std::optional<Vec3> first_in_tangent_ball(Refinement& r, TetId t, VertexId v, Level level) {
  const geom::Sphere sphere = geom::circumsphere(r.mesh().corners(t));
  const double radius = lattice::covering_radius(level);
  const Vec3 position = r.mesh().point(v);
  const Vec3 center = position + radius / std::sqrt(sphere.radius_sq) * (sphere.center - position);
  std::vector<Vec3> points;
  lattice::points_in_ball(level, center, radius, points);
  return first_in_conflict(r, t, points);
}

std::optional<Vec3> first_in_circumsphere(Refinement& r, TetId t, Level level) {
  const geom::Sphere sphere = geom::circumsphere(r.mesh().corners(t));
  std::vector<Vec3> points;
  lattice::points_in_ball(level, sphere.center, std::sqrt(sphere.radius_sq), points);
  return first_in_conflict(r, t, points);
}

namespace {

/// Sorts by distance from the centre; equally near ones stay in lexicographic order.
void sort_by_distance(std::vector<Vec3>& points, const Vec3& center) {
  std::stable_sort(points.begin(), points.end(),
                   [&](const Vec3& a, const Vec3& b) { return dist_sq(a, center) < dist_sq(b, center); });
}

std::optional<Candidate> certified(Refinement& r, TetId t, const Vec3& w) {
  const Level label = lattice::canonical_level(w);
  const double bound = inherited_lfs_bound(r, t, w);
  if (bound > figure_5_budget(label)) return std::nullopt;
  if (r.mesh().corner_at(t, w) != kNoVertex || !r.mesh().in_conflict(t, w)) return std::nullopt;
  return Candidate{w, label, bound};
}

}  // namespace

std::optional<Candidate> coarsest_in_circumsphere(Refinement& r, TetId t, Level finest) {
  const geom::Sphere sphere = geom::circumsphere(r.mesh().corners(t));
  const double radius = std::sqrt(sphere.radius_sq);
  std::vector<Vec3> points;
  for (Level level = lattice::coarsest_within(kCoarsestRadius * radius); level >= finest; --level) {
    points.clear();
    lattice::points_in_ball(level, sphere.center,
                            std::min(radius, kSearchRadius * lattice::covering_radius(level)), points);
    sort_by_distance(points, sphere.center);
    for (const Vec3& w : points)
      if (auto candidate = certified(r, t, w)) return candidate;
  }
  return std::nullopt;
}

}  // namespace unsliver::refine
