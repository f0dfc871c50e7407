/// \file
/// The shape of a background mesh: its boundary and whether it is convex.
#pragma once

#include "unsliver/mesh.hpp"

namespace unsliver::sizing {

/// The faces that belong to one tetrahedron only, turned outwards, over the mesh's own points.
TriangleMesh boundary_of(const TetMesh& mesh);

/// Is the boundary one closed surface that bends outwards, or stays flat, at every edge? Then it bounds a
/// convex body. Bends below 1e-10 rad count as flat.
bool is_convex(const TriangleMesh& boundary);

}  // namespace unsliver::sizing
