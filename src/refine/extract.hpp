/// \file
/// "When finished, remove all tetrahedra whose interiors do not intersect the domain."
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// The superset mesh in the caller's coordinates: tetrahedra in storage order, vertices in order of
/// insertion, but input vertices first, in the caller's order and with his coordinates.
TetMesh extract_superset(Refinement& refinement);

}  // namespace unsliver::refine
