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

Vec3 centroid(const Tet& t) { return 0.25 * ((t[0] + t[1]) + (t[2] + t[3])); }
Vec3 rounded(const Vec3& p) { return {std::nearbyint(p.x), std::nearbyint(p.y), std::nearbyint(p.z)}; }

}  // namespace

/// Every point of a tetrahedron has a corner v within the circumradius R, so R (1 + L) <= s(v) for all four
/// corners suffices.
bool SizeEnforcement::surely_covered(TetId t, double floor) {
  const Tet corners = r_.mesh().corners(t);
  const double radius_sq = geom::circumsphere(corners).radius_sq * (1 + kRounding);
  const double least = std::max(floor, r_.smallest_size());
  if (radius_sq <= least * least) return true;
  double smallest = std::numeric_limits<double>::infinity();
  for (VertexId v : r_.mesh().tet(t).v) smallest = std::min(smallest, r_.size_at_vertex(v).value_or(0));
  const double reach = std::max(smallest, floor) / (1 + r_.lipschitz());
  return radius_sq <= reach * reach;
}

SizeEnforcement::Verdict SizeEnforcement::judge(const Cell& cell, double floor) const {
  const double bound = std::max(floor, r_.size_lower_bound(bounding_box(cell)));
  for (const Listed& v : vertices_) {
    const double farthest = farthest_corner(cell, v.position);
    if (farthest <= std::max(bound, v.size / (1 + r_.lipschitz()))) return Verdict::kCovered;
  }
  return Verdict::kOpen;
}

void SizeEnforcement::list_vertex(VertexId v) {
  vertices_.push_back({r_.mesh().point(v), r_.size_at_vertex(v).value_or(-1)});
}

/// Is the ball about p (rounded) empty? A vertex found inside joins the list, so that it is not found again.
std::optional<EmptyBall> SizeEnforcement::try_center(const Vec3& p, double floor, TetId t) {
  const Vec3 q = rounded(p);
  const double size = std::max(floor, r_.size_at(q));
  const double radius_sq = (1 - kSizeSlack) * (1 - kSizeSlack) * size * size;
  for (const Listed& v : vertices_)
    if (dist_sq(v.position, q) <= radius_sq) return std::nullopt;
  const VertexId nearest = r_.nearest_vertex(q, t);
  if (dist_sq(r_.mesh().point(nearest), q) <= radius_sq) {
    list_vertex(nearest);
    return std::nullopt;
  }
  return EmptyBall{q, size};
}

/// Tries the cell's centre and corners; a small cell that meets the domain counts as if its centre did.
std::optional<EmptyBall> SizeEnforcement::probe(const Cell& cell, double floor, TetId t) {
  const Vec3 middle = centroid(cell);
  int a, b;
  const double diameter = longest_edge(cell, a, b);
  const double scale = std::max(floor, r_.smallest_size());
  if (diameter <= kWitnessSlack * scale) return try_center(middle, floor, t);
  for (const Vec3& p : {middle, cell[0], cell[1], cell[2], cell[3]})
    if (r_.contains(rounded(p)))
      if (auto ball = try_center(p, floor, t)) return ball;
  return std::nullopt;
}

std::optional<EmptyBall> SizeEnforcement::find_empty_ball(TetId t, double floor) {
  if (surely_covered(t, floor) || !r_.meets_domain(t)) return std::nullopt;
  const Tet corners = r_.mesh().corners(t);
  vertices_.clear();
  for (VertexId v : r_.mesh().tet(t).v) list_vertex(v);
  open_.assign(1, corners);
  while (!open_.empty()) {
    const Cell cell = open_.back();
    open_.pop_back();
    if (judge(cell, floor) == Verdict::kCovered) continue;
    if (!r_.meets_domain(cell)) continue;
    if (auto ball = probe(cell, floor, t)) return ball;
    int a, b;
    if (longest_edge(cell, a, b) <= 2) continue;  // below the resolution of the world nothing is left to find
    const Vec3 middle = 0.5 * (cell[a] + cell[b]);
    Cell half = cell;
    half[a] = middle;
    open_.push_back(half);
    half = cell;
    half[b] = middle;
    open_.push_back(half);
  }
  return std::nullopt;
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

Level simple_cubic_within(double radius) {
  const Level level = lattice::coarsest_within(radius);
  return lattice::is_bcc(level) ? level - 1 : level;
}

/// "By Lemma 3 there exists a point w of SC_j in B": the first in lexicographic order.
Vec3 first_in_ball(Level level, const Vec3& center) {
  std::vector<Vec3> points;
  lattice::points_in_ball(level, center, lattice::covering_radius(level), points);
  return points.empty() ? lattice::nearest(level, center) : points.front();
}

}  // namespace

void insert_for_size(Refinement& r, const EmptyBall& ball, TetId near, Strategy strategy) {
  const double radius = (1 - kSizeSlack) * ball.size * (1 + 1e-12);
  const bool literal = strategy == Strategy::kLiteral;
  const Level level = literal ? simple_cubic_within(radius) : lattice::coarsest_within(radius);
  if (level < r.world().finest_level()) refuse_tiny_size(r, ball);
  const Vec3 w = literal ? first_in_ball(level, ball.center) : lattice::nearest(level, ball.center);
  const double c = literal ? kFigure5LiteralC : kFigure5ThriftyC;
  const Level label = literal ? level : lattice::canonical_level(w);
  const double lfs_bound = (c + kWitnessSlack) * ball.size + dist(w, ball.center);
  r.insert(w, label, lfs_bound, near);
  ++r.stats().size_insertions;
}

namespace {

/// One round: all tetrahedra in storage order, the new ones of each neighbourhood at once.
void enforce_size_floor(Refinement& r, SizeEnforcement& search, double floor) {
  std::vector<TetId> pending;
  const std::size_t slots = r.mesh().slot_count();
  for (TetId t = 0; t < slots; ++t) {
    pending.assign(1, t);
    while (!pending.empty()) {
      const TetId next = pending.back();
      pending.pop_back();
      if (!r.mesh().is_finite(next)) continue;
      const auto ball = search.find_empty_ball(next, floor);
      if (!ball) continue;
      insert_for_size(r, *ball, next, Strategy::kThrifty);
      pending.insert(pending.end(), r.created().begin(), r.created().end());
    }
  }
}

}  // namespace

void enforce_size(Refinement& r) {
  SizeEnforcement search(r);
  double floor = r.smallest_size();
  while (floor < r.largest_size()) floor *= 2;
  for (; floor > r.smallest_size(); floor /= 2) enforce_size_floor(r, search, floor);
  enforce_size_floor(r, search, 0);
}

}  // namespace unsliver::refine
