#include "unsliver/error.hpp"

namespace unsliver {

const char* to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadOption:
      return "bad_option";
    case ErrorCode::kBadInput:
      return "bad_input";
    case ErrorCode::kFormat:
      return "format";
    case ErrorCode::kIo:
      return "io";
    case ErrorCode::kUnsupported:
      return "unsupported";
    case ErrorCode::kLimit:
      return "limit";
    case ErrorCode::kInternal:
      return "internal";
  }
  return "unknown";
}

}  // namespace unsliver
