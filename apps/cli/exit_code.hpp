/// \file
/// What the program tells its caller when it ends.
#pragma once

#include "unsliver/error.hpp"

namespace unsliver::cli {

enum class ExitCode : int {
  kDone = 0,   ///< the job is done (a mesh: verified, unless that was switched off)
  kLimit = 1,  ///< a cap, a limit or Ctrl-C ended the run; or `check` found the mesh at fault
  kUsage = 2,  ///< bad input, bad options, a file that cannot be read or written
  kBug = 3,    ///< unsliver contradicts itself
};

ExitCode exit_code_of(ErrorCode code);

}  // namespace unsliver::cli
