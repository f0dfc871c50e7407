/// \file
/// Does a mesh fill a box exactly, with its faces marked?
#pragma once

#include "unsliver/mesh.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::cli {

/// A line and findings "box" for the report: no vertex is outside of the box, each triangle lies on the face
/// that its label names (1 to 6: x low, x high, y low, ...), turned outward, and the triangles' areas add up
/// to the faces', exactly. With what verify() finds (each facet in one or two tetrahedra, a closed boundary,
/// no overlap) the union is the box. Requires a mesh of ours whose indices are valid.
void check_box(const TetMesh& mesh, const Box3& box, VerifyReport& report);

}  // namespace unsliver::cli
