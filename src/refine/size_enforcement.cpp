#include "refine/size_enforcement.hpp"

#include <fmt/format.h>

#include <limits>

#include "lattice/ball.hpp"
#include "refine/guarantees.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

constexpr double kRounding =
    1e-9;  // relative; covers the error of radii and distances in doubles many times over

double farthest_corner(const Tet& cell, const Vec3& from) {
  double farthest_sq = 0;
  for (const Vec3& corner : cell) farthest_sq = std::max(farthest_sq, dist_sq(corner, from));
  return std::sqrt(farthest_sq) * (1 + kRounding);
}

double longest_edge(const Tet& cell, int& a, int& b) {
  double longest_sq = -1;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (const double length_sq = dist_sq(cell[i], cell[j]); length_sq > longest_sq) {
        longest_sq = length_sq;
        a = i;
        b = j;
      }
  return std::sqrt(longest_sq);
}

double longest_edge(const Tet& cell) {
  int a, b;
  return longest_edge(cell, a, b);
}

Vec3 centroid(const Tet& t) { return 0.25 * ((t[0] + t[1]) + (t[2] + t[3])); }
/// A lower bound of the distance from x to the tetrahedron: how far its corners are along the direction of
/// its centroid.
double distance_lower_bound(const Tet& cell, const Vec3& x) {
  const Vec3 direction = centroid(cell) - x;
  const double length = norm(direction);
  if (length == 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& corner : cell) least = std::min(least, dot(corner - x, direction));
  return std::max(0.0, least / length * (1 - kRounding));
}

Vec3 rounded(const Vec3& p) { return {std::nearbyint(p.x), std::nearbyint(p.y), std::nearbyint(p.z)}; }

}  // namespace

/// What the circumsphere alone says. With c the circumcentre, R the circumradius and p in t at distance d
/// from c, some corner is within sqrt(R^2 - d^2) of p: the mean of the squared distances to the corners,
/// weighted by p's barycentric coordinates, is exactly R^2 - d^2. And s(p) >= s(c) - L d, so that R sqrt(1 +
/// L^2) <= s(c) covers all of t.
SizeEnforcement::Verdict SizeEnforcement::judge_circumsphere(TetId t) {
  sphere_ = geom::circumsphere(r_.mesh().corners(t));
  const double radius = std::sqrt(sphere_.radius_sq) * (1 + kRounding);
  double least = std::max(floor_, r_.smallest_size());
  if (radius <= least) return Verdict::kCovered;
  const double lipschitz = r_.lipschitz();
  center_size_ = r_.size_if_defined(sphere_.center);
  if (center_size_) {
    center_size_ = std::max(floor_, *center_size_);
    if (radius * std::sqrt(1 + lipschitz * lipschitz) <= *center_size_) return Verdict::kCovered;
    if (std::isfinite(lipschitz)) least = std::max(least, *center_size_ - lipschitz * radius);
  }
  if (!r_.meets_domain(t)) return Verdict::kCovered;
  // Only points nearer to c than `reach` can be uncovered.
  const double reach = std::sqrt(std::max(0.0, radius * radius - least * least));
  clearance_ = r_.clearance(sphere_.center);
  return clearance_ > reach ? Verdict::kCovered : Verdict::kOpen;
}

/// The ball about the circumcentre itself is empty by the Delaunay property: no search is needed when it is
/// in the domain and too large.
std::optional<EmptyBall> SizeEnforcement::try_circumcenter() const {
  if (!center_size_ || clearance_ > 0 || (clearance_ == 0 && !r_.contains(sphere_.center)))
    return std::nullopt;
  if (std::sqrt(sphere_.radius_sq) * (1 - kRounding) - 2 <= (1 - kSizeSlack) * *center_size_)
    return std::nullopt;
  return EmptyBall{rounded(sphere_.center), *center_size_};
}

/// A cell is covered if one vertex reaches all of it, or if it keeps away from the circumcentre (see
/// judge_circumsphere).
SizeEnforcement::Verdict SizeEnforcement::judge(const Cell& cell) const {
  double nearest = std::numeric_limits<double>::infinity(), size = std::max(floor_, r_.smallest_size());
  for (const Listed& v : vertices_) {
    const double farthest = farthest_corner(cell, v.position);
    nearest = std::min(nearest, farthest);
    size = std::max(size, v.size - r_.lipschitz() * farthest);
  }
  if (covers(cell, nearest, size)) return Verdict::kCovered;
  if (r_.constant_size() > 0) return Verdict::kOpen;
  size = std::max(floor_, r_.size_lower_bound(bounding_box(cell)));
  return covers(cell, nearest, size) ? Verdict::kCovered : Verdict::kOpen;
}

bool SizeEnforcement::covers(const Cell& cell, double nearest, double size) const {
  if (nearest <= size) return true;
  const double away = distance_lower_bound(cell, sphere_.center);
  return away * away > sphere_.radius_sq * (1 + kRounding) - size * size;
}

void SizeEnforcement::list_vertex(VertexId v) {
  vertices_.push_back({r_.mesh().point(v), r_.size_at_vertex(v).value_or(-1)});
}

/// Is the ball of `share` times the size about q empty? The nearest vertex joins the list: it is the best
/// witness that the cell is covered.
std::optional<EmptyBall> SizeEnforcement::try_center(const Vec3& q, double share, TetId t) {
  const auto defined = r_.contains(q) ? r_.size_at(q) : r_.size_if_defined(q);
  if (!defined) return std::nullopt;
  const double size = std::max(floor_, *defined);
  const double radius_sq = share * share * size * size;
  for (const Listed& v : vertices_)
    if (dist_sq(v.position, q) <= radius_sq) return std::nullopt;
  const VertexId nearest = r_.nearest_vertex(q, t);
  list_vertex(nearest);
  if (dist_sq(r_.mesh().point(nearest), q) <= radius_sq) return std::nullopt;
  return EmptyBall{q, size};
}

/// A small cell that meets the domain, but cannot be shown to be covered, counts as if its centre were in the
/// domain and its ball empty: at worst a vertex is inserted that was not needed yet. If that vertex is there
/// already, it joins the list.
std::optional<EmptyBall> SizeEnforcement::give_up(const Vec3& q, TetId t) {
  const auto ball = try_center(q, 1 - 2 * kWitnessSlack, t);
  if (!ball) return std::nullopt;
  const Vec3 w = lattice::nearest(fitting_level(*ball), ball->center);
  const VertexId existing = r_.mesh().corner_at(r_.mesh().locate(w, t), w);
  if (existing == kNoVertex) return ball;
  list_vertex(existing);
  return std::nullopt;
}

std::optional<EmptyBall> SizeEnforcement::probe(const Cell& cell, TetId t) {
  const Vec3 q = rounded(centroid(cell));
  const double least = std::max(floor_, r_.smallest_size());
  if (longest_edge(cell) <= kWitnessSlack * least) return give_up(q, t);
  double nearest_sq = std::numeric_limits<double>::infinity();
  for (const Listed& v : vertices_) nearest_sq = std::min(nearest_sq, dist_sq(v.position, q));
  if (nearest_sq <= (1 - kSizeSlack) * (1 - kSizeSlack) * least * least || !r_.contains(q))
    return std::nullopt;
  return try_center(q, 1 - kSizeSlack, t);
}

std::optional<EmptyBall> SizeEnforcement::find_empty_ball(TetId t) {
  if (judge_circumsphere(t) == Verdict::kCovered) return std::nullopt;
  if (auto ball = try_circumcenter()) return ball;
  vertices_.clear();
  for (VertexId v : r_.mesh().tet(t).v) list_vertex(v);
  open_.assign(1, r_.mesh().corners(t));
  while (!open_.empty()) {
    const Cell cell = open_.back();
    open_.pop_back();
    if (judge(cell) == Verdict::kCovered || !r_.meets_domain(cell)) continue;
    if (auto ball = probe(cell, t)) return ball;
    split(cell);
  }
  return std::nullopt;
}

void SizeEnforcement::split(const Cell& cell) {
  int a, b;
  if (longest_edge(cell, a, b) <= 2) return;  // below the resolution of the world nothing is left to find
  const Vec3 middle = 0.5 * (cell[a] + cell[b]);
  for (const int replaced : {a, b}) {
    Cell half = cell;
    half[replaced] = middle;
    open_.push_back(half);
  }
}

namespace {

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

Level SizeEnforcement::fitting_level(const EmptyBall& ball) const {
  const Level level = lattice::coarsest_within((1 - kSizeSlack) * ball.size * (1 + 1e-12));
  const bool literal = r_.strategy() == Strategy::kLiteral;
  return literal && lattice::is_bcc(level) ? level - 1 : level;
}

void SizeEnforcement::insert_for(const EmptyBall& ball, TetId near) {
  const bool literal = r_.strategy() == Strategy::kLiteral;
  const Level level = fitting_level(ball);
  if (level < r_.world().finest_level()) refuse_tiny_size(r_, ball);
  const Vec3 w = literal ? first_in_ball(level, ball.center) : lattice::nearest(level, ball.center);
  const double c = literal ? kFigure5LiteralC : kFigure5ThriftyC;
  const Level label = literal ? level : lattice::canonical_level(w);
  const double lfs_bound = (c + kWitnessSlack) * ball.size + dist(w, ball.center);
  r_.insert(w, label, lfs_bound, near);
  ++r_.stats().size_insertions;
}

/// One round: all tetrahedra in storage order, the new ones of each neighbourhood at once.
void SizeEnforcement::sweep(double floor) {
  floor_ = floor;
  std::vector<TetId> pending;
  const std::size_t slots = r_.mesh().slot_count();
  for (TetId first = 0; first < slots; ++first)
    for (pending.assign(1, first); !pending.empty();) {
      const TetId t = pending.back();
      pending.pop_back();
      if (!r_.mesh().is_finite(t)) continue;
      const auto ball = find_empty_ball(t);
      if (!ball) continue;
      insert_for(*ball, t);
      pending.insert(pending.end(), r_.created().begin(), r_.created().end());
    }
}

void enforce_size(Refinement& r) {
  SizeEnforcement enforcement(r);
  double floor = r.smallest_size();
  while (floor < r.largest_size()) floor *= 2;
  for (; floor > r.smallest_size(); floor /= 2) enforcement.sweep(floor);
  enforcement.sweep(0);
}

}  // namespace unsliver::refine
