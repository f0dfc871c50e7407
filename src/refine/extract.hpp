/// \file
/// "When finished, remove all tetrahedra whose interiors do not intersect the domain."
#pragma once

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// Which tetrahedra of the kernel are kept, in storage order, and the numbers of their vertices in the
/// result: in order of insertion, but input vertices first, in the caller's order. Stands until the
/// refinement goes on.
struct Extraction {
  explicit Extraction(Refinement& refinement);

  PodVector<TetId> kept;
  PodVector<VertexId> number;  ///< by vertex of the kernel; kNoVertex for those that are not used
  VertexId used;               ///< how many are
};

/// Vertices that size proofs rest on but no kept tetrahedron has, because all tetrahedra at them miss the
/// domain, are wanted from now on. Returns whether there were any: then the extraction is out of date, and
/// their tetrahedra may be bad.
bool want_dropped_proofs(Refinement& refinement, const Extraction& extraction);

/// The superset mesh in the caller's coordinates, those of input vertices bit for bit.
TetMesh extract_superset(const Refinement& refinement, const Extraction& extraction);

}  // namespace unsliver::refine
