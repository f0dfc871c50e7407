#include "refine/empty_ball.hpp"

#include <fmt/format.h>

#include <limits>

#include "lattice/ball.hpp"
#include "refine/guarantees.hpp"
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

[[noreturn]] void refuse_tiny_size(const Refinement& r, const EmptyBall& ball) {
  const Vec3 p = r.world().to_caller(ball.center);
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

/// "By Lemma 3 there exists a point w of SC_j in B": the first in lexicographic order.
Vec3 first_in_ball(Level level, const Vec3& center) {
  std::vector<Vec3> points;
  lattice::points_in_ball(level, center, lattice::covering_radius(level), points);
  return points.empty() ? lattice::nearest(level, center) : points.front();
}

}  // namespace

EmptyBallSearch::LatticePoint EmptyBallSearch::point_for(const EmptyBall& ball) const {
  Level level = lattice::coarsest_within((1 - kSizeSlack) * ball.size * (1 + 1e-12));
  const bool literal = r_.strategy() == Strategy::kLiteral;
  if (literal && lattice::is_bcc(level)) --level;
  if (level < r_.world().finest_level()) refuse_tiny_size(r_, ball);
  return {literal ? first_in_ball(level, ball.center) : lattice::nearest(level, ball.center), level};
}

double EmptyBallSearch::nearest_sq(const Cell& cell, const Vec3& p) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += square(std::max(0.0, std::abs(p[axis] - cell.center[axis]) - cell.half[axis]));
  return sum;
}

double EmptyBallSearch::farthest_sq(const Cell& cell, const Vec3& p) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += square(std::abs(p[axis] - cell.center[axis]) + cell.half[axis]);
  return sum;
}

std::optional<EmptyBall> EmptyBallSearch::find_quickly(TetId t, double floor) {
  floor_ = floor;
  open_question_ = !circumsphere_covers(t);
  return open_question_ ? try_circumcenter() : std::nullopt;
}

std::optional<EmptyBall> EmptyBallSearch::find(TetId t, double floor) {
  if (auto ball = find_quickly(t, floor)) return ball;
  return open_question_ ? branch_and_bound(t) : std::nullopt;
}

/// What the circumsphere alone says. For p in t at distance d from c, some corner is within sqrt(R^2 - d^2)
/// of p: the mean of the squared distances to the corners, weighted by p's barycentric coordinates, is
/// exactly R^2 - d^2. And s(p) >= s(c) - L d, so that R sqrt(1 + L^2) <= s(c) covers all of t.
bool EmptyBallSearch::circumsphere_covers(TetId t) {
  sphere_ = geom::circumsphere(r_.mesh().corners(t));
  const double radius = std::sqrt(sphere_.radius_sq) * (1 + kRounding), lipschitz = r_.lipschitz();
  double least = std::max(floor_, r_.smallest_size());
  if (radius <= least) return true;
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
std::optional<EmptyBall> EmptyBallSearch::try_circumcenter() const {
  if (!center_size_) return std::nullopt;
  const double size = std::max(floor_, *center_size_);
  if (std::sqrt(sphere_.radius_sq) * (1 - kRounding) - 2 <= (1 - kSizeSlack) * size) return std::nullopt;
  if (center_side_ == 0 && !r_.contains(sphere_.center)) return std::nullopt;
  return EmptyBall{rounded(sphere_.center), size};
}

std::optional<EmptyBall> EmptyBallSearch::branch_and_bound(TetId t) {
  aim_at(t);
  for (int cells = 1; !open_.empty(); ++cells) {
    if (cells % kPollInterval == 0) r_.poll();
    Cell cell = open_.back();
    open_.pop_back();
    if (misses_tet(cell)) continue;
    const auto center_size = r_.size_if_defined(cell.center);
    const double radius = norm(cell.half);
    double least = size_lower_bound(cell, center_size);
    if (covered(cell, least)) continue;
    if (center_size && r_.lipschitz() * radius > kSteep * *center_size) {
      least = std::max(least, r_.size_lower_bound({cell.center - cell.half, cell.center + cell.half}));
      if (covered(cell, least)) continue;
    }
    const int side = cell.inside ? -1 : r_.side_of_ball(cell.center, radius);
    if (side > 0) continue;
    cell.inside = side < 0;
    // Where s may jump, a tiny cell counts with the least s in it.
    const bool jump = radius <= kWitnessSlack * least && !std::isfinite(r_.lipschitz());
    if (!center_size && (cell.inside || r_.contains(cell.center)))
      r_.size_at(cell.center);  // says what is wrong
    if (center_size)
      if (auto ball = probe(cell, jump ? least : std::max(floor_, *center_size), t)) return ball;
    split(cell);
  }
  return std::nullopt;
}

/// Starts with t's corners, its facets, and the part of its bounding box that can be in the domain and
/// uncovered.
void EmptyBallSearch::aim_at(TetId t) {
  const Tet corners = r_.mesh().corners(t);
  vertices_.assign(corners.begin(), corners.end());
  for (int i = 0; i < 4; ++i) {
    const int* f = delaunay::kFacetCorners[i];
    const Vec3 normal = cross(corners[f[1]] - corners[f[0]], corners[f[2]] - corners[f[0]]);
    inward_[i] = 1 / norm(normal) * normal;
    offset_[i] = dot(inward_[i], corners[f[0]]);
  }
  Box3 box = bounding_box(corners);
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = std::max({box.lo[axis], r_.domain_box().lo[axis], sphere_.center[axis] - reach_});
    box.hi[axis] = std::min({box.hi[axis], r_.domain_box().hi[axis], sphere_.center[axis] + reach_});
  }
  open_.clear();
  if (!box.empty()) open_.push_back({box.center(), 0.5 * box.size(), false});
}

bool EmptyBallSearch::misses_tet(const Cell& cell) const {
  for (int i = 0; i < 4; ++i) {
    const Vec3& n = inward_[i];
    const double reach =
        std::abs(n.x) * cell.half.x + std::abs(n.y) * cell.half.y + std::abs(n.z) * cell.half.z;
    if (dot(n, cell.center) + reach * (1 + kRounding) + 1 < offset_[i]) return true;
  }
  return false;
}

double EmptyBallSearch::size_lower_bound(const Cell& cell, std::optional<double> center_size) const {
  const double least = std::max(floor_, r_.smallest_size());
  if (center_size && std::isfinite(r_.lipschitz()))
    return std::max(least, *center_size - r_.lipschitz() * norm(cell.half));
  return std::max(least, r_.size_lower_bound({cell.center - cell.half, cell.center + cell.half}));
}

double EmptyBallSearch::nearest_listed_sq(const Vec3& q) const {
  double nearest_sq = std::numeric_limits<double>::infinity();
  for (const Vec3& v : vertices_) nearest_sq = std::min(nearest_sq, dist_sq(v, q));
  return nearest_sq;
}

/// A cell is covered if one vertex reaches all of it, or if it keeps away from c (see circumsphere_covers).
bool EmptyBallSearch::covered(const Cell& cell, double size) const {
  const double size_sq = square(size) * (1 - kRounding);
  if (sphere_.radius_sq * (1 + kRounding) - nearest_sq(cell, sphere_.center) <= size_sq) return true;
  return std::any_of(vertices_.begin(), vertices_.end(),
                     [&](const Vec3& v) { return farthest_sq(cell, v) <= size_sq; });
}

/// Tries the cell's centre where it is in t and in the domain; a tiny cell counts as if it were. `size` is s
/// at the centre.
std::optional<EmptyBall> EmptyBallSearch::probe(const Cell& cell, double size, TetId t) {
  const EmptyBall ball{rounded(cell.center), size};
  const double radius = norm(cell.half), listed_sq = nearest_listed_sq(ball.center);
  const double hurry = r_.strategy() == Strategy::kLiteral ? kLiteralHurry : kThriftyHurry;
  const double share = radius <= hurry * size ? 1 - hurry : 1 - kSizeSlack;
  if (listed_sq <= square(share * size)) return std::nullopt;
  if (radius > kWitnessSlack * size &&
      (misses_tet({ball.center, {}, false}) || (!cell.inside && !r_.contains(ball.center))))
    return std::nullopt;
  if (listed_sq <= square((1 - kSizeSlack) * size)) return insert_rather_than_prove(ball, t);
  vertices_.push_back(r_.mesh().point(r_.nearest_vertex(ball.center, t)));
  if (dist_sq(vertices_.back(), ball.center) <= square((1 - kSizeSlack) * size)) return std::nullopt;
  return ball;
}

/// To show that a small cell is covered can cost more than a vertex, or not end where the bound is attained.
/// Where its centre is nearly uncovered the vertex is inserted at once: its certificate, c s(p) + |pw|, does
/// not depend on emptiness. If it is there already, it joins the list.
std::optional<EmptyBall> EmptyBallSearch::insert_rather_than_prove(const EmptyBall& ball, TetId t) {
  const Vec3 w = point_for(ball).w;
  if (std::find(vertices_.begin(), vertices_.end(), w) != vertices_.end()) return std::nullopt;
  if (r_.mesh().corner_at(r_.mesh().locate(w, t), w) == kNoVertex) return ball;
  vertices_.push_back(w);
  return std::nullopt;
}

/// Halves every long side. Below the resolution of the world nothing is left to find.
void EmptyBallSearch::split(const Cell& cell) {
  const double longest = std::max({cell.half.x, cell.half.y, cell.half.z});
  if (longest <= 1) return;
  const std::size_t first = open_.size();
  open_.push_back(cell);
  for (int axis = 0; axis < 3; ++axis) {
    if (cell.half[axis] <= 0.6 * longest) continue;
    for (std::size_t i = first, end = open_.size(); i < end; ++i) {
      open_[i].half[axis] *= 0.5;
      Cell other = open_[i];
      open_[i].center[axis] -= other.half[axis];
      other.center[axis] += other.half[axis];
      open_.push_back(other);
    }
  }
}

}  // namespace unsliver::refine
