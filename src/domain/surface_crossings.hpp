/// \file
/// Pairs of triangles of a surface that cross.
#pragma once

#include <functional>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::domain {

/// Calls found(s, t), s < t, for every two triangles of positive area that have a point in common besides
/// their common corners and edges; exact. Triangles with the same three corners are no pair. Stops soon after
/// `most` pairs: then it returns false. In a fixed order.
bool find_crossings(const std::vector<Vec3>& points, const std::vector<std::array<VertexId, 3>>& triangles,
                    std::size_t most, const std::function<void(std::size_t, std::size_t)>& found);

}  // namespace unsliver::domain
