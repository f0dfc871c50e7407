/// \file
/// What "in conflict" means: the geometric policies of the one kernel.
#pragma once

#include "delaunay/space.hpp"
#include "exact/predicates.hpp"
#include "unsliver/types.hpp"

namespace unsliver::delaunay {

/// How many calls each stage of each predicate decided.
struct PredicateCounts {
  exact::StageCounts orient, conflict;
};

/// Plain points: in conflict = strictly inside the circumsphere, ties by symbolic perturbation.
struct Unweighted {
  using Point = Vec3;
  using Space = Bounded;

  static const Vec3& position(const Point& p) { return p; }

  /// Requires a, b, c, d positively oriented and p distinct from them.
  static bool in_conflict(const Point& a, const Point& b, const Point& c, const Point& d, const Point& p,
                          PredicateCounts& counts) {
    return exact::insphere_perturbed(a, b, c, d, p, counts.conflict) > 0;
  }
};

/// The same on a torus. The perturbation compares places as they are seen from one frame, and the order of
/// places does not depend on the frame: ties are decided alike in all frames.
struct PeriodicUnweighted : Unweighted {
  using Space = Torus;
};

}  // namespace unsliver::delaunay
