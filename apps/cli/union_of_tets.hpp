/// \file
/// The solid that a tetrahedral mesh fills, as a surface.
#pragma once

#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::cli {

/// The vertices that some tetrahedron uses, ascending. Requires valid indices, here and below.
std::vector<VertexId> used_vertices(const TetMesh& mesh);

/// The triangles that bound the union of the tetrahedra: the facets of one tetrahedron only, outward where
/// that tetrahedron has a positive volume in doubles. Points are those the triangles use.
TriangleMesh boundary_surface(const TetMesh& mesh);

}  // namespace unsliver::cli
