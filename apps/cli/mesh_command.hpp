/// \file
/// What `unsliver mesh` and `unsliver refine` share: from parsed options to the exit code.
#pragma once

#include "exit_code.hpp"
#include "mesh_options.hpp"

namespace unsliver::cli {

/// Checks the options, runs, and publishes the report, whatever the end was. \throws Error, published.
ExitCode run_mesh_command(MeshCommandOptions& options);

}  // namespace unsliver::cli
