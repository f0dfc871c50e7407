#include "refine/empty_ball.hpp"

#include <fmt/format.h>

#include <limits>

#include "lattice/ball.hpp"
#include "refine/guarantees.hpp"
#include "refine/periodic_refinement.hpp"
#include "refine/refinement.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

constexpr double kRounding =
    1e-9;  // relative; covers the error of radii and distances in doubles many times over
// A cell below this share of s is not split for long: a vertex costs less than the proof that none is needed.
constexpr double kLiteralHurry = kWitnessSlack;
constexpr double kThriftyHurry = 0.2;
// Where s varies by more than this share over a cell, its global Lipschitz constant is no good bound.
constexpr double kSteep = 0.3;
constexpr int kPollInterval = 1024;  // cells

double square(double x) { return x * x; }
Vec3 rounded(const Vec3& p) { return {std::nearbyint(p.x), std::nearbyint(p.y), std::nearbyint(p.z)}; }

template <class R>
[[noreturn]] void refuse_tiny_size(const R& r, const EmptyBall& ball) {
  const Vec3 p = r.to_caller(ball.center);
  const double finest = lattice::covering_radius(r.world().finest_level()) * r.world().unit();
  Error error(
      ErrorCode::kLimit,
      fmt::format(
          "the size {} asked for at ({}, {}, {}) is below {}, the finest lattice that doubles can represent "
          "across this domain; ask for larger sizes or move the domain nearer to the origin",
          ball.size * r.world().unit(), p.x, p.y, p.z, finest));
  error.places.push_back(p);
  throw error;
}

/// The points of the level within r(level) of the centre ("by Lemma 3 there exists a point w of SC_j in B"):
/// in lexicographic order, or the nearest first.
std::vector<Vec3> points_of_level(Level level, const Vec3& center, bool nearest_first) {
  std::vector<Vec3> points;
  lattice::points_in_ball(level, center, lattice::covering_radius(level), points);
  if (points.empty()) points.push_back(lattice::nearest(level, center));
  if (nearest_first)
    std::stable_sort(points.begin(), points.end(),
                     [&](const Vec3& a, const Vec3& b) { return dist_sq(a, center) < dist_sq(b, center); });
  return points;
}

}  // namespace

template <class R>
LatticePoint point_for(const R& r, const EmptyBall& ball) {
  const bool literal = r.strategy() == Strategy::kLiteral;
  Level level = lattice::coarsest_within((1 - kSizeSlack) * ball.size * (1 + 1e-12));
  for (;; --level) {
    if (literal && lattice::is_bcc(level)) --level;
    if (level < r.world().finest_level()) refuse_tiny_size(r, ball);
    if (r.inputs().empty() && !literal) return {lattice::nearest(level, ball.center), level};
    for (const Vec3& w : points_of_level(level, ball.center, !literal))
      if (r.inputs().region_is_empty(w, level)) return {w, level};
  }
}

template <class R>
std::optional<EmptyBall> EmptyBallSearch<R>::find_quickly(TetId t, double floor) {
  floor_ = floor;
  open_question_ = !circumsphere_covers(t);
  return open_question_ ? try_circumcenter() : std::nullopt;
}

template <class R>
std::optional<EmptyBall> EmptyBallSearch<R>::find(TetId t, double floor) {
  if (auto ball = find_quickly(t, floor)) return ball;
  return open_question_ ? branch_and_bound(t) : std::nullopt;
}

/// What the circumsphere alone says. For p in t at distance d from c, some corner is within sqrt(R^2 - d^2)
/// of p: the mean of the squared distances to the corners, weighted by p's barycentric coordinates, is
/// exactly R^2 - d^2. And s(p) >= s(c) - L d, so that R sqrt(1 + L^2) <= s(c) covers all of t.
template <class R>
bool EmptyBallSearch<R>::circumsphere_covers(TetId t) {
  sphere_ = circumsphere(r_.mesh().corners(t));
  double least = std::max(floor_, r_.smallest_size());
  if (sphere_.radius_sq * (1 + 3 * kRounding) <= square(least)) return true;
  const double radius = std::sqrt(sphere_.radius_sq) * (1 + kRounding), lipschitz = r_.lipschitz();
  center_size_ = r_.size_if_defined(sphere_.center);
  if (center_size_) {
    const double size = std::max(floor_, *center_size_);
    if (radius * std::sqrt(1 + lipschitz * lipschitz) <= size) return true;
    if (std::isfinite(lipschitz)) least = std::max(least, size - lipschitz * radius);
  }
  if (!r_.meets_domain(t)) return true;
  reach_ = std::sqrt(std::max(0.0, radius * radius - least * least));
  center_side_ = r_.side_of_ball(sphere_.center, reach_);
  return center_side_ > 0;  // farther than this from c all is covered
}

/// The ball about c itself is empty by the Delaunay property: no search is needed when c is in the domain and
/// R too large.
template <class R>
std::optional<EmptyBall> EmptyBallSearch<R>::try_circumcenter() const {
  if (!center_size_) return std::nullopt;
  const double size = std::max(floor_, *center_size_);
  if (std::sqrt(sphere_.radius_sq) * (1 - kRounding) - 2 <= (1 - kSizeSlack) * size) return std::nullopt;
  if (center_side_ == 0 && !r_.contains(sphere_.center)) return std::nullopt;
  return EmptyBall{rounded(sphere_.center), size};
}

template <class R>
auto EmptyBallSearch<R>::hull_of(const Tet& corners) -> Hull {
  const Vec3 center = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  double radius_sq = 0;
  for (const Vec3& corner : corners) radius_sq = std::max(radius_sq, dist_sq(corner, center));
  return {center, std::sqrt(radius_sq)};
}

template <class R>
std::optional<EmptyBall> EmptyBallSearch<R>::branch_and_bound(TetId t) {
  corners_ = r_.mesh().corners(t);
  for (int i = 0; i < 4; ++i) clearances_[i] = r_.clearance(r_.mesh().tet(t).v[i]);
  vertices_.assign(corners_.begin(), corners_.end());
  open_.assign(1, {corners_, false});
  const double least_everywhere = std::max(floor_, r_.smallest_size());
  for (int cells = 1; !open_.empty(); ++cells) {
    if (cells % kPollInterval == 0) r_.poll();
    Cell cell = open_.back();
    open_.pop_back();
    if (one_vertex_reaches(cell.corners, least_everywhere)) continue;
    const Hull hull = hull_of(cell.corners);
    if (beyond_domain_box(cell.corners, hull)) continue;
    const auto center_size = r_.size_if_defined(hull.center);
    double least = size_lower_bound(cell.corners, hull, center_size);
    if (covered(cell.corners, hull, least)) continue;
    if (center_size && r_.lipschitz() * hull.radius > kSteep * *center_size) {
      least = std::max(least, r_.size_lower_bound(bounding_box(cell.corners)));
      if (covered(cell.corners, hull, least)) continue;
    }
    const int side = side_of(cell, hull);
    if (side > 0) continue;
    cell.inside = side < 0;
    // Where s may jump, a tiny cell counts with the least s in it.
    const bool jump = hull.radius <= kWitnessSlack * least && !std::isfinite(r_.lipschitz());
    if (!center_size && (cell.inside || r_.contains(hull.center)))
      r_.size_at(hull.center);  // says what is wrong
    if (center_size)
      if (auto ball = probe(cell, hull, jump ? least : std::max(floor_, *center_size), t)) return ball;
    split(cell);
  }
  return std::nullopt;
}

/// +1 if the cell lies certainly outside the domain, -1 if certainly inside, 0 if it may do neither. The
/// balls about t's corners are known, and save most questions.
template <class R>
int EmptyBallSearch<R>::side_of(const Cell& cell, const Hull& hull) const {
  if (cell.inside) return -1;
  const double radius = hull.radius * (1 + kRounding);
  for (int i = 0; i < 4; ++i)
    if (dist(corners_[i], hull.center) * (1 + kRounding) + radius <= std::abs(clearances_[i]))
      return clearances_[i] > 0 ? 1 : -1;
  if (r_.plainly_outside(cell.corners)) return 1;
  return r_.side_of_ball(hull.center, radius);
}

/// A cell that only touches the box from outside counts as beyond it: what it shares with the domain is part
/// of other cells too, unless the domain is flat.
template <class R>
bool EmptyBallSearch<R>::beyond_domain_box(const Tet& cell, const Hull& hull) const {
  const Box3& domain = r_.domain_box();
  if (domain.contains(hull.center)) return false;
  const Box3 box = bounding_box(cell);
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = domain.lo[axis], hi = domain.hi[axis];
    if (lo < hi ? box.lo[axis] >= hi || box.hi[axis] <= lo : box.lo[axis] > hi || box.hi[axis] < lo)
      return true;
  }
  return false;
}

template <class R>
double EmptyBallSearch<R>::size_lower_bound(const Tet& cell, const Hull& hull,
                                            std::optional<double> center_size) const {
  const double least = std::max(floor_, r_.smallest_size());
  if (center_size && std::isfinite(r_.lipschitz()))
    return std::max(least, *center_size - r_.lipschitz() * hull.radius);
  return std::max(least, r_.size_lower_bound(bounding_box(cell)));
}

template <class R>
double EmptyBallSearch<R>::nearest_listed_sq(const Vec3& q) const {
  double nearest_sq = std::numeric_limits<double>::infinity();
  for (const Vec3& v : vertices_) nearest_sq = std::min(nearest_sq, dist_sq(v, q));
  return nearest_sq;
}

/// Does some vertex reach all of the cell? Balls are convex, so the corners tell.
template <class R>
bool EmptyBallSearch<R>::one_vertex_reaches(const Tet& cell, double size) const {
  const double size_sq = square(size) * (1 - kRounding);
  for (const Vec3& v : vertices_)
    if (dist_sq(cell[0], v) <= size_sq && dist_sq(cell[1], v) <= size_sq && dist_sq(cell[2], v) <= size_sq &&
        dist_sq(cell[3], v) <= size_sq)
      return true;
  return false;
}

/// A cell that keeps away from c is covered too: see circumsphere_covers.
template <class R>
bool EmptyBallSearch<R>::covered(const Tet& cell, const Hull& hull, double size) const {
  const double from_center = std::max(0.0, dist(hull.center, sphere_.center) - hull.radius);
  if (sphere_.radius_sq * (1 + kRounding) - square(from_center) <= square(size) * (1 - kRounding))
    return true;
  return one_vertex_reaches(cell, size);
}

/// Tries the cell's centre where it is in the domain; a tiny cell counts as if it were. `size` is s at the
/// centre.
template <class R>
std::optional<EmptyBall> EmptyBallSearch<R>::probe(const Cell& cell, const Hull& hull, double size, TetId t) {
  const EmptyBall ball{rounded(hull.center), size};
  const double radius = hull.radius, listed_sq = nearest_listed_sq(ball.center);
  const double hurry = r_.strategy() == Strategy::kLiteral ? kLiteralHurry : kThriftyHurry;
  const double share = radius <= hurry * size ? 1 - hurry : 1 - kSizeSlack;
  if (listed_sq <= square(share * size)) return std::nullopt;
  if (radius > kWitnessSlack * size && !cell.inside && !r_.contains(ball.center)) return std::nullopt;
  // The size step beside input vertices counts on a ball that holds none of them.
  const bool nearly = listed_sq <= square((1 - kSizeSlack) * size);
  if (nearly && r_.inputs().empty()) return insert_rather_than_prove(ball, t);
  const auto nearest = r_.nearest_vertex(ball.center, t);
  vertices_.push_back(nearest.place);
  const double nearest_sq = dist_sq(vertices_.back(), ball.center);
  std::optional<EmptyBall> found;
  if (nearest_sq > square((1 - kSizeSlack) * size))
    found = ball;
  else if (nearest_sq > square(share * size))
    found = insert_rather_than_prove(ball, t);
  if (!found) r_.rely_on(nearest.v);
  return found;
}

/// To show that a small cell is covered can cost more than a vertex, or not end where the bound is attained.
/// Where its centre is nearly uncovered the vertex is inserted at once: its certificate, c s(p) + |pw|, does
/// not depend on emptiness (beside input vertices: only on a ball of radius 1 - hurry, see guarantees.hpp).
/// If it is there already, it joins the list.
template <class R>
std::optional<EmptyBall> EmptyBallSearch<R>::insert_rather_than_prove(const EmptyBall& ball, TetId t) {
  const Vec3 w = point_for(r_, ball).w;
  if (std::find(vertices_.begin(), vertices_.end(), w) != vertices_.end()) return std::nullopt;
  Vec3 seen = w;
  const VertexId v = r_.mesh().corner_at(r_.mesh().walk_to(seen, t), seen);
  if (v == kNoVertex) return ball;
  vertices_.push_back(w);
  r_.rely_on(v);
  return std::nullopt;
}

/// Halves the longest edge. Below the resolution of the world nothing is left to find.
template <class R>
void EmptyBallSearch<R>::split(const Cell& cell) {
  int from = 0, to = 1;
  double longest_sq = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (const double length_sq = dist_sq(cell.corners[i], cell.corners[j]); length_sq > longest_sq)
        longest_sq = length_sq, from = i, to = j;
  if (longest_sq <= square(2)) return;
  const Vec3 middle = 0.5 * (cell.corners[from] + cell.corners[to]);
  open_.push_back(cell);
  open_.back().corners[from] = middle;
  open_.push_back(cell);
  open_.back().corners[to] = middle;
}

template class EmptyBallSearch<Refinement>;
template class EmptyBallSearch<PeriodicRefinement>;
template LatticePoint point_for(const Refinement&, const EmptyBall&);
template LatticePoint point_for(const PeriodicRefinement&, const EmptyBall&);

}  // namespace unsliver::refine
