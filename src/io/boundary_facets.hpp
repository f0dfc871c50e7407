/// \file
/// The facets that a tetrahedral mesh ends at.
#pragma once

#include <array>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// The facets of exactly one tetrahedron, outward by the right hand, ordered by their vertices. Any mesh will
/// do, inverted tetrahedra included. O(n log n).
std::vector<std::array<VertexId, 3>> boundary_facets(const TetMesh& mesh);

}  // namespace unsliver::io
