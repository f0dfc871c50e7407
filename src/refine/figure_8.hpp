/// \file
/// Labelle's Figure 8: a superset mesh of a domain with quality tetrahedra that respects input vertices.
#pragma once

#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

/// The figure to the letter, first in first out; but for the size step, see point_for.
template <class R>
void figure_8_literal(R& refinement);

/// The same invariants, fewer vertices: all size enforcement first, then the bad tetrahedra by circumradius,
/// with certified candidates from the coarsest level that has one, and the figure's own cases where none is
/// certified.
template <class R>
void figure_8_thrifty(R& refinement);
/// Its second part alone.
template <class R>
void figure_8_quality(R& refinement);

/// One thrifty step for a bad tetrahedron: a certified candidate, or the figure's own case.
template <class R>
void enforce_quality(R& refinement, TetId bad);

}  // namespace unsliver::refine
