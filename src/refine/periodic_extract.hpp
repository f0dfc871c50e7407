/// \file
/// What the kernel, or a forest, has made of a torus as a mesh of the cell.
#pragma once

#include "refine/periodic_refinement.hpp"

namespace unsliver::refine {

/// Tetrahedra in storage order. First the input vertices in the caller's order, then the others in order of
/// insertion, then copies.
TetMesh extract_periodic(const PeriodicRefinement& refinement);

/// The same of a mesh whose points are all at home and whose tetrahedra name them whatever copies they mean:
/// the nearest, tetrahedra being narrower than half a period. Labels are made no coarser than `coarsest`.
TetMesh unfold_periodic(TetMesh homes, const Box3& cell, Level coarsest);

}  // namespace unsliver::refine
