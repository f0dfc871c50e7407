/// \file
/// Every vertex against every circumsphere, by search.
#pragma once

#include "verify/context.hpp"
#include "verify/kd_tree.hpp"
#include "verify/sites.hpp"

namespace unsliver::verifier {

/// A box that holds the circumsphere: slack for rounding, everything where the centre is badly conditioned.
Box3 search_box(const Tet& tet);

/// Findings "delaunay": a used vertex strictly inside the circumsphere of a tetrahedron (exact). Slow.
void check_delaunay_globally(const Context& context, const Sites& sites, const KdTree& vertices);

}  // namespace unsliver::verifier
