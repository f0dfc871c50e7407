/// \file
/// Checks of input: finite, in range, and such that signs of degree 3 neither overflow nor underflow.
#pragma once

#include <string>

#include "unsliver/mesh.hpp"
#include "unsliver/types.hpp"

namespace unsliver::domain {

/// \throws Error kBadInput naming `what` unless the box is finite, not empty, its longest side is between
/// 1e-60 and 1e60 and its coordinates are below 1e75 in magnitude.
void require_usable_range(const Box3& box, const std::string& what);

/// \throws Error kBadInput for a coordinate that is not finite or an index out of range, naming the first.
void require_valid_surface(const TriangleMesh& surface);

/// "(x, y, z)", each as short as it can be and still exact.
std::string format_point(const Vec3& p);

}  // namespace unsliver::domain
