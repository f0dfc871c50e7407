/// \file
/// What the surface readers share: polygons into triangles, and the last check.
#pragma once

#include <span>

#include "io/scanner.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// Appends the fan of triangles of a polygon around its first corner. Error kFormat below 3 corners.
void add_polygon(std::span<const VertexId> corners, const Scanner& place, TriangleMesh& mesh);

/// Error kLimit when a mesh cannot number that many vertices.
void require_numberable(std::size_t vertex_count, const Scanner& place);

/// Error kBadInput when there is no triangle.
void require_triangles(const TriangleMesh& mesh);

}  // namespace unsliver::io
