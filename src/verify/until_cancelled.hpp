/// \file
/// What a report says when the caller ends a verification.
#pragma once

#include "verify/pulse.hpp"
#include "verify/report.hpp"

namespace unsliver::verifier {

/// Runs the checks. Finding "cancelled": they were ended before their end.
template <class Checks>
void run_until_cancelled(Reporter& reporter, const Checks& checks) {
  try {
    checks();
  } catch (const Cancelled&) {
    reporter.find("cancelled", {},
                  [] { return std::string("the verification was cancelled before its end"); });
    reporter.line("cancelled: the checks that are not listed above were not finished");
  }
}

}  // namespace unsliver::verifier
