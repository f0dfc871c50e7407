/// \file
/// What the rounding of input vertices to the frame's grid means at the coordinates of the mesh.
#pragma once

#include "verify/context.hpp"
#include "verify/sites.hpp"

namespace unsliver::verifier {

/// Tetrahedra with a vertex that was judged rounded, looked at where it really is: findings "orientation"
/// when one is not positive there (exact); a line with their extreme angles (in doubles: a measure, not a
/// verdict).
void check_rounding(const Context& context, const FramePlaces& places);

}  // namespace unsliver::verifier
