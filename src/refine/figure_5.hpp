/// \file
/// Labelle's Figure 5: a simple algorithm to create a superset mesh of a domain with quality tetrahedra.
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// The figure to the letter, first in first out.
void figure_5_literal(Refinement& refinement);

/// The same invariants, fewer vertices: all size enforcement first, then quality enforcement with certified
/// candidates from the coarsest level, and the figure's own cases where none is certified.
void figure_5_thrifty(Refinement& refinement);
/// Its second part alone.
void figure_5_quality(Refinement& refinement);

}  // namespace unsliver::refine
