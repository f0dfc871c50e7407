/// \file
/// Makes the triangles of a surface face the same way as their neighbours.
#pragma once

#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::domain {

/// Turns triangles so that any two at an edge of exactly two triangles run along it in opposite directions.
/// Patches (triangles joined by such edges) that agree already, or cannot, stay as they are; a patch that is
/// changed ends up with positive volume about the middle of the surface. Returns how many triangles were
/// turned.
std::size_t turn_to_agree(const std::vector<Vec3>& points, std::vector<std::array<VertexId, 3>>& triangles);

}  // namespace unsliver::domain
