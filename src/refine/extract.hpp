/// \file
/// "When finished, remove all tetrahedra whose interiors do not intersect the domain."
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// Vertices that size proofs rest on but no kept tetrahedron has, because all tetrahedra at them miss the
/// domain, are wanted from now on. Returns whether there were any: their tetrahedra may be bad.
bool want_dropped_proofs(Refinement& refinement);

/// The superset mesh in the caller's coordinates: tetrahedra in storage order, vertices in order of
/// insertion, but input vertices first, in the caller's order and with his coordinates.
TetMesh extract_superset(Refinement& refinement);

}  // namespace unsliver::refine
