/// \file
/// What every check is given.
#pragma once

#include "verify/pulse.hpp"
#include "verify/report.hpp"

namespace unsliver::verifier {

/// The mesh has passed check_structure: its indices and coordinates can be trusted.
struct Context {
  const TetMesh& mesh;
  const VerifyOptions& options;
  Reporter& reporter;
  Pulse& pulse;
};

}  // namespace unsliver::verifier
