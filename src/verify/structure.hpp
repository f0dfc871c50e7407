/// \file
/// Can the mesh be read at all? Array lengths, indices, coordinates, frame; then what needs no facets.
#pragma once

#include <vector>

#include "verify/context.hpp"

namespace unsliver::verifier {

/// Finding "coordinates" for a frame that is no grid of integers.
void check_frame(const Frame& frame, Reporter& reporter);

/// Findings "index" and "coordinates". False: no other check may run.
bool check_structure(const Context& context);

/// Vertices used by some tetrahedron, ascending.
std::vector<VertexId> used_vertices(const TetMesh& mesh);

/// Findings "conformity" for two used vertices at one place.
void check_coincident(const Context& context, const std::vector<VertexId>& used);

}  // namespace unsliver::verifier
