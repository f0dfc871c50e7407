/// \file
/// One pass over the vertices of a streamed mesh, and a few more for pairs at one place.
#pragma once

#include "verify/stream_context.hpp"

namespace unsliver::verifier {

/// Findings "coordinates" and "lattice". False: some coordinates cannot be read on the frame's grid, no other
/// check may run.
bool check_stream_points(const StreamContext& context);

/// Findings "conformity" for two vertices at one place. Requires: coordinates are finite.
void check_stream_coincident(const StreamContext& context);

}  // namespace unsliver::verifier
