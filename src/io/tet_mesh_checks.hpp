/// \file
/// Checks that the readers and writers of tetrahedral meshes share.
#pragma once

#include <string>

#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// Error kBadInput when there is no tetrahedron.
void require_tets(const TetMesh& mesh, const std::string& name);

/// Error kBadInput unless every index is valid and every optional array is empty or has its stated length.
void require_consistent(const TetMesh& mesh);

}  // namespace unsliver::io
