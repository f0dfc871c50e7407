#include "refine/candidates.hpp"

#include <algorithm>

#include "lattice/ball.hpp"
#include "refine/guarantees.hpp"
#include "refine/periodic_refinement.hpp"
#include "refine/refinement.hpp"
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

template <class R>
bool conflicts(const R& r, TetId t, const Vec3& w) {
  return r.mesh().corner_at(t, w) == kNoVertex && r.mesh().in_conflict(t, w);
}

template <class R>
std::optional<Vec3> first_conflicting(const R& r, TetId t, std::span<const Vec3> points) {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const Vec3& w) { return conflicts(r, t, w); });
  return found == points.end() ? std::nullopt : std::optional(*found);
}

std::vector<Vec3> points_in_ball(Level level, const Vec3& center, double radius) {
  std::vector<Vec3> points;
  points.reserve(32);
  lattice::points_in_ball(level, center, radius, points);
  return points;
}

template <class R>
double inherited_lfs_bound(const R& r, TetId t, const Vec3& w) {
  double bound = std::numeric_limits<double>::infinity();
  for (VertexId v : r.mesh().tet(t).v) bound = std::min(bound, r.lfs_bound(v) + dist(r.mesh().point(v), w));
  return bound * (1 + 1e-9);
}

template <class R>
std::vector<Vec3> points_in_tangent_ball(const R& r, const geom::Sphere& sphere, VertexId v, Level level) {
  const double radius = lattice::covering_radius(level);
  return points_in_ball(level, tangent_center(sphere, r.mesh().point(v), radius), radius);
}

std::vector<Vec3> points_in_circumsphere(const geom::Sphere& sphere, Level level) {
  return points_in_ball(level, sphere.center, std::sqrt(sphere.radius_sq));
}

namespace {

/// Removes and returns the point nearest to the centre; of equally near ones, the first.
Vec3 take_nearest(std::vector<Vec3>& points, const Vec3& center) {
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return dist_sq(a, center) < dist_sq(b, center);
  });
  const Vec3 w = *nearest;
  points.erase(nearest);
  return w;
}

/// The certificate of a label for w, as a bound of lfs(w): inherited from a corner, or from two input
/// vertices nearby (lfs is no more than lfs_i).
template <class R>
std::optional<double> certificate(R& r, TetId t, const Vec3& w, Level label) {
  const double inherited = inherited_lfs_bound(r, t, w);
  if (r.inputs().empty())
    return inherited <= figure_5_budget(label) ? std::optional(inherited) : std::nullopt;
  const double budget = figure_8_tight_budget(label);
  if (inherited <= budget) return inherited;
  return r.inputs().lfs_at_most(w, budget) ? std::optional(budget) : std::nullopt;
}

/// The search for one bad tetrahedron.
template <class R>
class CandidateSearch {
 public:
  CandidateSearch(R& r, TetId t) : r_(r), t_(t), sphere_(circumsphere(r.mesh().corners(t))) {
    for (const VertexId v : r.mesh().tet(t).v)
      if (r.is_input(v)) inputs_[input_count_++] = r.mesh().point(v);
  }

  std::optional<Candidate> run(Level finest) {
    const double radius = std::sqrt(sphere_.radius_sq);
    const double to_input = input_count_ > 0 ? radius : std::numeric_limits<double>::infinity();
    const Level coarsest = std::min(r_.coarsest_level(), lattice::coarsest_within(kCoarsestRadius * radius));
    for (Level level = coarsest; level >= finest; --level) {
      const double reach = std::min(radius, kSearchRadius * lattice::covering_radius(level));
      if (r_.inputs().no_region_is_empty(level, to_input + reach)) continue;
      if (auto candidate = of_level(level, reach)) return candidate;
    }
    return std::nullopt;
  }

 private:
  /// Of the level's points that are inside the sphere, the admissible one nearest to its centre.
  std::optional<Candidate> of_level(Level level, double reach) {
    const Vec3 nearest = lattice::nearest(level, sphere_.center);
    if (dist_sq(nearest, sphere_.center) > sphere_.radius_sq * (1 + 1e-9)) return std::nullopt;
    if (auto candidate = admissible(nearest, level)) return candidate;
    points_.clear();
    lattice::points_in_ball(level, sphere_.center, reach, points_);
    std::erase(points_, nearest);
    while (!points_.empty())
      if (auto candidate = admissible(take_nearest(points_, sphere_.center), level)) return candidate;
    return std::nullopt;
  }

  /// In the order of what most points fail by, and of what is cheap.
  std::optional<Candidate> admissible(const Vec3& w, Level level) {
    if (region_holds_corner(w, level) || !r_.inputs().region_is_empty(w, level) || !conflicts(r_, t_, w))
      return std::nullopt;
    const Level label = r_.inputs().coarsest_label(w, level);
    const auto bound = certificate(r_, t_, w, label);
    return bound ? std::optional(Candidate{w, label, *bound}) : std::nullopt;
  }

  bool region_holds_corner(const Vec3& w, Level level) const {
    return std::any_of(inputs_.begin(), inputs_.begin() + input_count_,
                       [&](const Vec3& u) { return lattice::in_forbidden_region(w, level, u); });
  }

  R& r_;
  TetId t_;
  geom::Sphere sphere_;
  std::array<Vec3, 4> inputs_;  ///< those among t's corners
  int input_count_ = 0;
  std::vector<Vec3> points_;  ///< scratch
};

}  // namespace

template <class R>
std::optional<Candidate> coarsest_in_circumsphere(R& r, TetId t, Level finest) {
  return CandidateSearch(r, t).run(finest);
}

template bool conflicts(const Refinement&, TetId, const Vec3&);
template bool conflicts(const PeriodicRefinement&, TetId, const Vec3&);
template std::optional<Vec3> first_conflicting(const Refinement&, TetId, std::span<const Vec3>);
template std::optional<Vec3> first_conflicting(const PeriodicRefinement&, TetId, std::span<const Vec3>);
template double inherited_lfs_bound(const Refinement&, TetId, const Vec3&);
template double inherited_lfs_bound(const PeriodicRefinement&, TetId, const Vec3&);
template std::vector<Vec3> points_in_tangent_ball(const Refinement&, const geom::Sphere&, VertexId, Level);
template std::vector<Vec3> points_in_tangent_ball(const PeriodicRefinement&, const geom::Sphere&, VertexId,
                                                  Level);
template std::optional<Candidate> coarsest_in_circumsphere(Refinement&, TetId, Level);
template std::optional<Candidate> coarsest_in_circumsphere(PeriodicRefinement&, TetId, Level);

}  // namespace unsliver::refine
