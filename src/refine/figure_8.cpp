// Labelle's Figure 8. Notation: t a bad tetrahedron of circumcentre c and circumradius R; v its refinement
// vertex with the finest label, SC_k or BCC_{k+1}; u1, u2 input vertices nearby; w the vertex to insert.
// With levels as one chain (lattice/level.hpp) Cases 1.1 and 1.2 read the same: w comes from the next coarser
// lattice than v's label, and k is that of the label's forbidden region.
#include "refine/figure_8.hpp"

#include <cassert>

#include "refine/candidates.hpp"
#include "refine/first_in_first_out.hpp"
#include "refine/guarantees.hpp"
#include "refine/periodic_refinement.hpp"
#include "refine/refinement.hpp"

namespace unsliver::refine {

namespace {

using lattice::covering_radius;
using lattice::kHalfSqrt3;
using lattice::kRho;
using lattice::power_of_two;

constexpr Level sc(int k) { return 2 * k + 1; }

/// One bad tetrahedron.
struct Bad {
  template <class R>
  Bad(const R& r, TetId tet) : t(tet), sphere(circumsphere(r.mesh().corners(tet))), v(r.finest_corner(tet)) {
    for (const VertexId corner : r.mesh().tet(tet).v)
      if (r.is_input(corner)) inputs.push_back(r.mesh().point(corner));
  }
  TetId t;
  geom::Sphere sphere;
  VertexId v;                ///< kNoVertex where all corners are input vertices
  std::vector<Vec3> inputs;  ///< those among the corners
};

template <class R>
void count(R& r, Subcase subcase) {
  ++r.stats().figure_8[static_cast<std::size_t>(subcase)];
}

/// "By construction no input point is in the forbidden region" or it was looked up: the invariant, Table 2's
/// distance and inequality (1).
template <class R>
void insert(R& r, const Bad& bad, const Vec3& w, Level label, double lfs_bound,
            [[maybe_unused]] double table_2) {
  assert(r.inputs().region_is_empty(w, label));
  assert(lfs_bound <= figure_8_budget(label) * (1 + 1e-6));
  assert(dist(bad.v == kNoVertex ? w : r.mesh().point(bad.v), w) <= table_2 * (1 + 1e-9));
  r.insert_in_conflict(w, label, lfs_bound, bad.t);
  ++r.stats().quality_insertions;
}

/// "There exists a point w" among these in conflict with t: the literal strategy takes the first in
/// lexicographic order. The thrifty one prefers a point with an empty region, in a coarse lattice, near c.
template <class R>
Vec3 choose(const R& r, const Bad& bad, Level label, std::vector<Vec3> points, const char* promise) {
  if (r.strategy() != Strategy::kLiteral) {
    std::erase_if(points, [&](const Vec3& w) { return !conflicts(r, bad.t, w); });
    const auto score = [&](const Vec3& w) {
      return lattice::canonical_level(w) -
             0.5 * std::sqrt(dist_sq(w, bad.sphere.center) / bad.sphere.radius_sq);
    };
    std::stable_sort(points.begin(), points.end(),
                     [&](const Vec3& a, const Vec3& b) { return score(a) > score(b); });
    for (const Vec3& w : points)
      if (r.inputs().region_is_empty(w, label)) return w;
  }
  const auto first = first_conflicting(r, bad.t, points);
  if (!first) broken_promise(promise);
  return *first;
}

template <class R>
void case_3(R& r, const Bad& bad) {
  count(r, Subcase::k3);
  const double radius = std::sqrt(bad.sphere.radius_sq);
  int j = std::ilogb(radius / (kHalfSqrt3 + kRho));
  if (power_of_two(j) * (kHalfSqrt3 + kRho) >= radius * (1 - 1e-12)) --j;
  const Level label = sc(j);
  if (label < r.world().finest_level()) broken_promise("the least distance of input vertices");
  auto points = points_in_ball(label, bad.sphere.center, covering_radius(label));
  const Vec3 w = choose(r, bad, label, std::move(points), "Lemma 3");
  insert(r, bad, w, label, power_of_two(j) * kFigure8Alpha, 2 * radius);
}

/// 2.1: the points of SC_k in a ball B' of radius r(SC_k) that lies in the ball B of that radius + `margin`,
/// tangent at v, as far as possible from u1.
template <class R>
std::vector<Vec3> points_of_2_1(const R& r, const Bad& bad, const Vec3& u1, int k, double margin) {
  const Vec3 center = tangent_center(bad.sphere, r.mesh().point(bad.v), covering_radius(sc(k)) + margin);
  const double distance = dist(center, u1);
  const Vec3 shift = distance > 0 ? margin / distance * (center - u1) : Vec3{margin, 0, 0};
  return points_in_ball(sc(k), center + shift, covering_radius(sc(k)));
}

template <class R>
void case_2(R& r, const Bad& bad, const Vec3& u1) {
  const int k = lattice::region_exponent(r.label(bad.v));
  const double margin = power_of_two(k) * kRho / 2, radius = covering_radius(sc(k)) + margin;
  const bool large = exceeds(bad.sphere.radius_sq, radius);
  if (!large && std::any_of(bad.inputs.begin(), bad.inputs.end(), [&](const Vec3& u) { return u != u1; })) {
    count(r, Subcase::k23);
    return case_3(r, bad);
  }
  count(r, large ? Subcase::k21 : Subcase::k22);
  std::vector<Vec3> points =
      large ? points_of_2_1(r, bad, u1, k, margin) : points_in_circumsphere(bad.sphere, sc(k));
  std::erase_if(points, [&](const Vec3& w) { return lattice::in_forbidden_region(w, sc(k), u1); });
  const Vec3 w = choose(r, bad, sc(k), std::move(points), large ? "Lemma 3" : "Corollary 9");
  if (!r.inputs().region_is_empty(w, sc(k))) return case_3(r, bad);
  const double inherited = r.lfs_bound(bad.v) + dist(r.mesh().point(bad.v), w);
  insert(r, bad, w, sc(k), std::min(inherited, power_of_two(k) * kFigure8A), 2 * radius);
}

/// 1.1.1 and 1.2.1, or 1.2.3: a point of the next coarser lattice. None where 1.1.2 or 1.2.2 apply.
template <class R>
std::optional<Vec3> point_of_case_1(R& r, const Bad& bad, Level level) {
  const bool next_is_bcc = lattice::is_bcc(level);
  if (exceeds(bad.sphere.radius_sq, covering_radius(level))) {
    count(r, next_is_bcc ? Subcase::k111 : Subcase::k121);
    return choose(r, bad, level, points_in_tangent_ball(r, bad.sphere, bad.v, level), "Lemma 3");
  }
  if (!bad.inputs.empty()) {
    count(r, next_is_bcc ? Subcase::k112 : Subcase::k122);
    return std::nullopt;
  }
  count(r, next_is_bcc ? Subcase::k113 : Subcase::k123);
  if (next_is_bcc) broken_promise("Lemma 5");
  return choose(r, bad, level, points_in_circumsphere(bad.sphere, level), "Lemma 6");
}

template <class R>
void case_1(R& r, const Bad& bad) {
  const Level level = r.label(bad.v) + 1;
  const auto w = point_of_case_1(r, bad, level);
  if (!w) return case_2(r, bad, bad.inputs.front());
  if (const auto u1 = r.inputs().in_region(*w, level)) return case_2(r, bad, *u1);
  const double inherited = r.lfs_bound(bad.v) + dist(r.mesh().point(bad.v), *w);
  insert(r, bad, *w, level, inherited, 2 * covering_radius(level));
}

/// Where both cases apply, the literal strategy chooses Case 1.
template <class R>
void enforce_quality_literally(R& r, TetId t) {
  const Bad bad(r, t);
  bad.v == kNoVertex ? case_3(r, bad) : case_1(r, bad);
}

/// The bad tetrahedra that wait for the thrifty strategy, by circumradius.
template <class R>
class BadTets {
 public:
  explicit BadTets(R& r) : r_(r) {}

  void push_if_bad(std::span<const TetId> tets) {
    finite_.clear();
    corners_.clear();
    for (const TetId t : tets) {
      if (!r_.mesh().is_finite(t)) continue;
      finite_.push_back(t);
      corners_.push_back(r_.mesh().corners(t));
    }
    judgements_.resize(finite_.size());
    r_.judge(corners_, judgements_);
    for (std::size_t i = 0; i < finite_.size(); ++i)
      if (judgements_[i].is_bad) queue_.push(queued(r_, finite_[i]), judgements_[i].radius_sq);
  }

  /// The next one that is still there.
  std::optional<TetId> pop() {
    while (const auto next = queue_.pop())
      if (still_there(r_, *next)) return next->slot;
    return std::nullopt;
  }

 private:
  R& r_;
  RadiusQueue queue_;
  std::vector<TetId> finite_;  ///< scratch, as the next two
  std::vector<Tet> corners_;
  std::vector<exact::Judgement> judgements_;
};

}  // namespace

/// The certificate is all that termination needs, so the levels go down as far as the world's.
template <class R>
void enforce_quality(R& r, TetId t) {
  const auto c = coarsest_in_circumsphere(r, t, r.world().finest_level());
  if (!c) return enforce_quality_literally(r, t);
  r.insert_in_conflict(c->w, c->label, c->lfs_bound, t);
  ++r.stats().candidates;
  ++r.stats().quality_insertions;
}

template <class R>
void figure_8_literal(R& r) {
  first_in_first_out(r, [&r](TetId t) { enforce_quality_literally(r, t); });
}

template <class R>
void figure_8_thrifty(R& r) {
  r.enter_phase("size");
  enforce_size(r);
  figure_8_quality(r);
}

template <class R>
void figure_8_quality(R& r) {
  r.enter_phase("quality");
  BadTets bad(r);
  for (TetId t = 0; t < r.mesh().slot_count(); ++t) bad.push_if_bad({&t, 1});
  while (const auto next = bad.pop()) {
    if (!r.meets_domain(*next)) continue;
    enforce_quality(r, *next);
    bad.push_if_bad(r.created());
  }
}

template void figure_8_literal(Refinement&);
template void figure_8_literal(PeriodicRefinement&);
template void figure_8_thrifty(Refinement&);
template void figure_8_thrifty(PeriodicRefinement&);
template void figure_8_quality(Refinement&);
template void figure_8_quality(PeriodicRefinement&);

template void enforce_quality(Refinement&, TetId);
template void enforce_quality(PeriodicRefinement&, TetId);

}  // namespace unsliver::refine
