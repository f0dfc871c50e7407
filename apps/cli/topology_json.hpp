/// \file
/// A periodic mesh as what it is: vertices, and tetrahedra by vertices and periods.
#pragma once

#include <nlohmann/json.hpp>

#include "unsliver/mesh.hpp"

namespace unsliver::cli {

/// The fields are described in docs/JSON.md. Requires a periodic mesh.
nlohmann::ordered_json topology_json(const TetMesh& mesh);

}  // namespace unsliver::cli
