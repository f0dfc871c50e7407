/// \file
/// The lattice points w that may be inserted for a bad tetrahedron t. R is Refinement or PeriodicRefinement.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lattice/level.hpp"
#include "refine/circumsphere.hpp"
#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

/// A chosen point with its label and the certificate of inequality (1).
struct Candidate {
  Vec3 w;
  Level label;
  double lfs_bound;
};

/// Lemma 3, 5 or 6 or Corollary 9 promised a point. If the promise fails there is a bug in the arithmetic,
/// not in the input. \throws Error kInternal.
[[noreturn]] void broken_promise(const char* lemma);

/// Is the circumradius larger than the radius? Where lattices attain the radius, rounding must not say so.
inline bool exceeds(double circumradius_sq, double radius) {
  return circumradius_sq > radius * radius * (1 + 1e-12);
}

/// min over t's corners v of lfs_bound(v) + |vw|: Lemma 1.
template <class R>
double inherited_lfs_bound(const R& refinement, TetId t, const Vec3& w);

/// Is w in conflict with t and none of its corners?
template <class R>
bool conflicts(const R& refinement, TetId t, const Vec3& w);

/// The first of the points that conflicts with t. (Lemma 3 leaves out the tangent point, a corner of t;
/// points on the circumsphere are in conflict or not by the perturbation.)
template <class R>
std::optional<Vec3> first_conflicting(const R& refinement, TetId t, std::span<const Vec3> points);

/// The points of `level` in the closed ball, in lexicographic order.
std::vector<Vec3> points_in_ball(Level level, const Vec3& center, double radius);

/// The centre of the ball of this radius that is tangent at v inside a sphere through v.
inline Vec3 tangent_center(const geom::Sphere& sphere, const Vec3& v, double radius) {
  return v + radius / std::sqrt(sphere.radius_sq) * (sphere.center - v);
}

/// The points of `level` in the ball of radius r(level) tangent at v inside t's circumsphere ("by Lemma 3
/// there exists a point w in B \ {v}"). Requires t's circumradius > r(level).
template <class R>
std::vector<Vec3> points_in_tangent_ball(const R& refinement, const geom::Sphere& sphere, VertexId v,
                                         Level level);

/// The points of `level` in the circumsphere (Lemma 6, Corollary 9).
std::vector<Vec3> points_in_circumsphere(const geom::Sphere& sphere, Level level);

/// Thrifty: among the levels from the coarsest that can have points inside t's circumsphere down to `finest`,
/// the first level with an admissible point: in conflict with t and certified within its label's budget. Of
/// that level's points the one nearest to the circumcentre.
/// \note With input vertices (Figure 8) admissible means also that the level's forbidden region is empty; the
/// label is then the coarsest that the point can carry.
template <class R>
std::optional<Candidate> coarsest_in_circumsphere(R& refinement, TetId t, Level finest);

}  // namespace unsliver::refine
