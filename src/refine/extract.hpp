/// \file
/// "When finished, remove all tetrahedra whose interiors do not intersect the domain."
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// The superset mesh in the caller's coordinates: tetrahedra in storage order, vertices in order of
/// insertion.
TetMesh extract_superset(Refinement& refinement);

}  // namespace unsliver::refine
