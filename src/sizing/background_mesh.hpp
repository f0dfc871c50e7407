/// \file
/// The shape of a background mesh's boundary.
#pragma once

#include "unsliver/mesh.hpp"

namespace unsliver::sizing {

/// Is the boundary one closed surface that bends outwards, or stays flat, at every edge? Then it bounds a
/// convex body. Bends below 1e-10 rad count as flat.
bool is_convex(const TriangleMesh& boundary);

}  // namespace unsliver::sizing
