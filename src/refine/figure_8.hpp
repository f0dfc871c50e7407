/// \file
/// Labelle's Figure 8: a superset mesh of a domain with quality tetrahedra that respects input vertices.
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// The figure to the letter, first in first out; but for the size step, see point_for.
void figure_8_literal(Refinement& refinement);

/// The same invariants, fewer vertices: all size enforcement first, then the bad tetrahedra by circumradius,
/// with certified candidates from the coarsest level that has one, and the figure's own cases where none is
/// certified.
void figure_8_thrifty(Refinement& refinement);
/// Its second part alone.
void figure_8_quality(Refinement& refinement);

/// One thrifty step for a bad tetrahedron: a certified candidate, or the figure's own case.
void enforce_quality(Refinement& refinement, TetId bad);

}  // namespace unsliver::refine
