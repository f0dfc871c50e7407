/// \file
/// Which tetrahedra share a facet: every facet of the mesh, matched by sorting.
#pragma once

#include <vector>

#include "verify/facet.hpp"
#include "verify/pulse.hpp"
#include "verify/report.hpp"

namespace unsliver::verifier {

/// What matching found.
struct Facets {
  /// 4 per tetrahedron. Entry 4 t + i is the vertex beyond the facet of t opposite to corner i, given for the
  /// one of the two tetrahedra with the smaller id only; kNoVertex elsewhere.
  std::vector<VertexId> beyond;
  /// Those of exactly one tetrahedron.
  std::vector<Facet> boundary;
  std::uint64_t interior = 0;  ///< facets of exactly two tetrahedra
};

/// Findings "conformity": a facet in three or more tetrahedra or in two on its same side; a tetrahedron that
/// is there twice. Requires: indices in range, no vertex twice in a tetrahedron, fewer than 2^32 tetrahedra.
/// Time O(m log d), d facets a vertex; memory 64 bytes a tetrahedron, 48 of them freed on return.
Facets match_facets(const TetMesh& mesh, Reporter* reporter, Pulse& pulse);

}  // namespace unsliver::verifier
