#include "exit_code.hpp"

namespace unsliver::cli {

ExitCode exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kLimit:
      return ExitCode::kLimit;
    case ErrorCode::kInternal:
      return ExitCode::kBug;
    default:
      return ExitCode::kUsage;
  }
}

}  // namespace unsliver::cli
