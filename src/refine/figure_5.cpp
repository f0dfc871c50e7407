// Labelle's Figure 5. Notation: t a bad tetrahedron, v its corner with the finest label, `level` the next
// coarser lattice than v's label, r(level) its covering radius, w the vertex to insert. With levels as one
// chain (lattice/level.hpp) Case 1 (label SC_k, w in BCC_{k+1}) and Case 2 (label BCC_k, w in SC_k) read the
// same, but for Lemma 6.
#include "refine/figure_5.hpp"

#include "refine/candidates.hpp"
#include "refine/first_in_first_out.hpp"
#include "refine/last_in_first_out.hpp"
#include "refine/periodic_refinement.hpp"
#include "refine/refinement.hpp"

namespace unsliver::refine {

namespace {

/// Quality enforcement of Figure 5, Cases 1 and 2: the first point in lexicographic order.
template <class R>
Vec3 figure_5_case(R& r, TetId t, VertexId v, Level level) {
  const geom::Sphere sphere = circumsphere(r.mesh().corners(t));
  const bool large = exceeds(sphere.radius_sq, lattice::covering_radius(level));
  if (!large && lattice::is_bcc(level)) broken_promise("Lemma 5");  // Case 1 cannot be bad then
  if (!large) ++r.stats().lemma_6_insertions;
  const auto points =
      large ? points_in_tangent_ball(r, sphere, v, level) : points_in_circumsphere(sphere, level);
  const auto w = first_conflicting(r, t, points);
  if (!w) broken_promise(large ? "Lemma 3" : "Lemma 6");
  return *w;
}

template <class R>
void enforce_quality_literally(R& r, TetId t) {
  const VertexId v = r.finest_corner(t);
  const Level level = r.label(v) + 1;
  const Vec3 w = figure_5_case(r, t, v, level);
  r.insert_in_conflict(w, level, inherited_lfs_bound(r, t, w), t);
  ++r.stats().quality_insertions;
}

template <class R>
void enforce_quality_thriftily(R& r, TetId t) {
  if (auto c = coarsest_in_circumsphere(r, t, r.label(r.finest_corner(t)) + 1)) {
    r.insert_in_conflict(c->w, c->label, c->lfs_bound, t);
    ++r.stats().quality_insertions;
  } else {
    enforce_quality_literally(r, t);
  }
}

}  // namespace

template <class R>
void figure_5_literal(R& r) {
  first_in_first_out(r, [&r](TetId t) { enforce_quality_literally(r, t); });
}

template <class R>
void figure_5_thrifty(R& r) {
  r.enter_phase("size");
  enforce_size(r);
  figure_5_quality(r);
}

template <class R>
void figure_5_quality(R& r) {
  r.enter_phase("quality");
  last_in_first_out(r, [&r](TetId t, std::vector<TetId>& pending) {
    if (!r.mesh().is_finite(t) || !r.is_bad(t) || !r.meets_domain(t)) return;
    enforce_quality_thriftily(r, t);
    pending.insert(pending.end(), r.created().begin(), r.created().end());
  });
}

template void figure_5_literal(Refinement&);
template void figure_5_literal(PeriodicRefinement&);
template void figure_5_thrifty(Refinement&);
template void figure_5_thrifty(PeriodicRefinement&);
template void figure_5_quality(Refinement&);
template void figure_5_quality(PeriodicRefinement&);

}  // namespace unsliver::refine
