/// \file
/// The work behind `unsliver mesh`.
#pragma once

#include "mesh_options.hpp"
#include "mesh_report.hpp"

namespace unsliver::cli {

/// Reads, estimates, meshes, verifies and writes. Ensures that the report's status and exit code are set.
/// Requires options that check_mesh_options has passed. \throws Error; the report holds what was known by
/// then.
void run_mesh(const MeshCommandOptions& options, MeshReport& report);

}  // namespace unsliver::cli
