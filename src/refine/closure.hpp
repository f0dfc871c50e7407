/// \file
/// Parent closure with the kernel: size enforcement on a set of lattice points that holds the parents of each
/// of its points. No tetrahedron of it is bad (docs/CLOSURE.md), so quality needs no queue and no test.
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// The coarsest lattice, SC_45: its cubes are as large as the domain, and all of its points around the domain
/// are vertices from the start.
inline constexpr Level kTopLevel = 2 * 45 + 1;

/// Requires no input vertices.
void closure(Refinement& refinement);

}  // namespace unsliver::refine
