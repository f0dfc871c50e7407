/// \file
/// The one exception type of the library: bad input, named so that its author can mend it.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver {

enum class ErrorCode {
  kBadOption,    ///< an option is out of range, contradictory or without effect
  kBadInput,     ///< a file's or array's content is unusable (NaN, empty, index out of range, ...)
  kFormat,       ///< a file does not have the syntax of its format
  kIo,           ///< the operating system refused to read or write
  kUnsupported,  ///< valid, but outside what this version does
  kLimit,        ///< the job would exceed a cap (size, memory, coordinate range) before it starts
  kInternal,     ///< a bug in unsliver
};

/// Short name of a code, as it appears in JSON reports: "bad_option", "bad_input", ...
const char* to_string(ErrorCode code);

/// Thrown at the public boundary. what() is a full sentence: what is wrong, where, and what to do.
class Error : public std::exception {
 public:
  Error(ErrorCode code, std::string message) : code_(code), message_(std::move(message)) {}

  ErrorCode code() const { return code_; }
  const char* what() const noexcept override { return message_.c_str(); }

  /// Ids of offending elements (vertices, triangles, lines: the message says which), may be empty.
  std::vector<std::int64_t> ids;
  /// Coordinates of the offending places, in the caller's units, may be empty.
  std::vector<Vec3> places;

 private:
  ErrorCode code_;
  std::string message_;
};

}  // namespace unsliver
