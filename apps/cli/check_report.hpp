/// \file
/// What `unsliver check` found, as a table and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "exit_code.hpp"
#include "unsliver/quality.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::cli {

struct CheckReport {
  std::string file, against;
  ExitCode exit_code = ExitCode::kDone;
  std::size_t vertices = 0;
  Box3 bounds;
  bool ours = false;                     ///< it carries its lattice, so it claims the guarantees
  std::optional<QualityLimits> held_to;  ///< the limits it was judged by
  QualitySummary quality;
  VerifyReport verified;
};

/// For people: counts, extremes, histogram, worst tetrahedra, verdict.
std::string to_table(const CheckReport& report);

/// The fields are described in docs/JSON.md.
nlohmann::ordered_json to_json(const CheckReport& report);

}  // namespace unsliver::cli
