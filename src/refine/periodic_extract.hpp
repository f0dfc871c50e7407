/// \file
/// From the torus to a mesh of the cell, with copies of the vertices where tetrahedra reach beyond.
#pragma once

#include "refine/periodic_refinement.hpp"

namespace unsliver::refine {

/// Tetrahedra in storage order, each (but for a few) where its least corner along each axis is in the cell.
/// First the input vertices in the caller's order, then the others in order of insertion, then copies.
TetMesh extract_periodic(const PeriodicRefinement& refinement);

}  // namespace unsliver::refine
