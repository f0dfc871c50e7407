#include "refine/candidates.hpp"

#include <algorithm>

#include "lattice/ball.hpp"
#include "refine/guarantees.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

// Beyond this covering radius, in circumradii, a lattice rarely has a point inside the sphere.
constexpr double kCoarsestRadius = 2.2;
// Points farther than this from the circumcentre, in covering radii, are passed over for nearer ones of a
// finer level.
constexpr double kSearchRadius = 1.5;

}  // namespace

void broken_promise(const char* lemma) {
  throw Error(ErrorCode::kInternal,
              std::string("no lattice point found where ") + lemma +
                  " of Labelle 2006 promises one: this is a bug in unsliver, please report it");
}

std::vector<Vec3> conflicting_points(Refinement& r, TetId t, Level level, const Vec3& center, double radius) {
  std::vector<Vec3> points;
  lattice::points_in_ball(level, center, radius, points);
  std::erase_if(points, [&](const Vec3& w) {
    return r.mesh().corner_at(t, w) != kNoVertex || !r.mesh().in_conflict(t, w);
  });
  return points;
}

double inherited_lfs_bound(const Refinement& r, TetId t, const Vec3& w) {
  double bound = std::numeric_limits<double>::infinity();
  for (VertexId v : r.mesh().tet(t).v) bound = std::min(bound, r.lfs_bound(v) + dist(r.mesh().point(v), w));
  return bound * (1 + 1e-9);
}

std::vector<Vec3> points_in_tangent_ball(Refinement& r, TetId t, const geom::Sphere& sphere, VertexId v,
                                         Level level) {
  const double radius = lattice::covering_radius(level);
  return conflicting_points(r, t, level, tangent_center(sphere, r.mesh().point(v), radius), radius);
}

std::vector<Vec3> points_in_circumsphere(Refinement& r, TetId t, const geom::Sphere& sphere, Level level) {
  return conflicting_points(r, t, level, sphere.center, std::sqrt(sphere.radius_sq));
}

namespace {

/// Sorts by distance from the centre; equally near ones stay in lexicographic order.
void sort_by_distance(std::vector<Vec3>& points, const Vec3& center) {
  std::stable_sort(points.begin(), points.end(),
                   [&](const Vec3& a, const Vec3& b) { return dist_sq(a, center) < dist_sq(b, center); });
}

/// The certificate of a label for w, as a bound of lfs(w): inherited from a corner, or from two input
/// vertices nearby (lfs is no more than lfs_i).
std::optional<double> certificate(Refinement& r, TetId t, const Vec3& w, Level label) {
  const double inherited = inherited_lfs_bound(r, t, w);
  if (r.inputs().empty())
    return inherited <= figure_5_budget(label) ? std::optional(inherited) : std::nullopt;
  const double budget = figure_8_tight_budget(label);
  if (inherited <= budget) return inherited;
  return r.inputs().lfs_at_most(w, budget) ? std::optional(budget) : std::nullopt;
}

std::optional<Candidate> admissible(Refinement& r, TetId t, const Vec3& w, Level level) {
  if (r.mesh().corner_at(t, w) != kNoVertex || !r.mesh().in_conflict(t, w)) return std::nullopt;
  if (!r.inputs().region_is_empty(w, level)) return std::nullopt;
  const Level label = r.inputs().coarsest_label(w, level);
  const auto bound = certificate(r, t, w, label);
  return bound ? std::optional(Candidate{w, label, *bound}) : std::nullopt;
}

}  // namespace

std::optional<Candidate> coarsest_in_circumsphere(Refinement& r, TetId t, Level finest) {
  const geom::Sphere sphere = circumsphere(r.mesh().corners(t));
  const double radius = std::sqrt(sphere.radius_sq);
  std::vector<Vec3> points;
  for (Level level = lattice::coarsest_within(kCoarsestRadius * radius); level >= finest; --level) {
    const Vec3 nearest = lattice::nearest(level, sphere.center);
    if (dist_sq(nearest, sphere.center) > sphere.radius_sq * (1 + 1e-9))
      continue;  // no point of it is inside
    if (auto candidate = admissible(r, t, nearest, level)) return candidate;
    points.clear();
    lattice::points_in_ball(level, sphere.center,
                            std::min(radius, kSearchRadius * lattice::covering_radius(level)), points);
    sort_by_distance(points, sphere.center);
    for (const Vec3& w : points)
      if (auto candidate = admissible(r, t, w, level)) return candidate;
  }
  return std::nullopt;
}

}  // namespace unsliver::refine
