/// \file
/// Parent closure with the kernel: size enforcement on a set of lattice points that holds the parents of each
/// of its points. No tetrahedron of it is bad (docs/CLOSURE.md), so quality needs no queue and no test.
#pragma once

#include "lattice/level.hpp"

namespace unsliver::refine {

class Refinement;
class PeriodicRefinement;

/// The coarsest lattice, SC_45: its cubes are as large as the domain, and all of its points around the domain
/// are vertices from the start.
inline constexpr lattice::Level kTopLevel = 2 * 45 + 1;

/// Requires no input vertices.
void closure(Refinement& refinement);
/// On a torus. All points of some lattice are vertices from the start.
void closure(PeriodicRefinement& refinement);

}  // namespace unsliver::refine
