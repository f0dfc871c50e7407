/// \file
/// Labelle's Figure 5: a simple algorithm to create a superset mesh of a domain with quality tetrahedra.
#pragma once

#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

/// The figure to the letter, first in first out.
template <class R>
void figure_5_literal(R& refinement);

/// The same invariants, fewer vertices: all size enforcement first, then quality enforcement with certified
/// candidates from the coarsest level, and the figure's own cases where none is certified.
template <class R>
void figure_5_thrifty(R& refinement);
/// Its second part alone.
template <class R>
void figure_5_quality(R& refinement);

}  // namespace unsliver::refine
