/// \file
/// What "in conflict" means: the geometric policies of the one kernel.
#pragma once

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

  static const Vec3& position(const Point& p) { return p; }

  /// Requires a, b, c, d positively oriented and p distinct from them.
  static bool in_conflict(const Point& a, const Point& b, const Point& c, const Point& d, const Point& p,
                          PredicateCounts& counts) {
    return exact::insphere_perturbed(a, b, c, d, p, counts.conflict) > 0;
  }
};

}  // namespace unsliver::delaunay
