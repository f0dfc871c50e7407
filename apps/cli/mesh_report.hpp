/// \file
/// Everything a run of `unsliver mesh` has to tell, filled in as the run goes along; as a table and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "domain_source.hpp"
#include "exit_code.hpp"
#include "size_request.hpp"
#include "unsliver/error.hpp"
#include "unsliver/quality.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::cli {

struct MeshCounts {
  std::size_t vertices = 0, tets = 0, boundary_triangles = 0;
  std::size_t input_vertices = 0;  ///< of the vertices
};

struct MeshReport {
  std::string command = "mesh";  ///< or "refine"
  /// "done", "tet_cap", "memory_cap", "cancelled"; "refused" before the start; "verification_failed";
  /// "error".
  std::string status = "error";
  ExitCode exit_code = ExitCode::kBug;
  std::optional<MeshOptions> options;  ///< once they are known to make sense
  std::optional<DomainSource> source;
  std::optional<SizeSource> size;
  std::optional<SizeEstimate> estimate;
  std::optional<MeshStats> stats;
  std::optional<MeshCounts> counts;
  std::optional<QualitySummary> quality;
  std::optional<VerifyReport> verified;
  std::vector<std::string> notes;  ///< what else a careful user must know of this run
  std::string output;              ///< where the mesh was written; empty when it was not
  std::vector<PhaseTime> phases;
  double total_seconds = 0;
  std::optional<Error> error;

  /// Is every promise of the options kept, as far as the generator can tell?
  bool guaranteed() const { return status == "done"; }
  /// ... and as far as the independent checker can?
  bool is_verified() const { return verified && verified->ok; }
};

/// Requires that exact tests have found the limits kept. What was measured in doubles is given to 12 digits,
/// and never beyond a limit: an angle of 30 degrees may have come out as 29.999999999999996.
void round_extremes(const QualityLimits& kept, VerifyReport& verified, QualitySummary& quality);

/// "1.1180", or "unbounded" for infinity.
std::string ratio_text(double ratio);

/// A short table for people, ending in a newline.
std::string to_table(const MeshReport& report);

/// The fields are described in docs/JSON.md.
nlohmann::ordered_json to_json(const MeshReport& report);

/// The parts that `unsliver check` shares.
nlohmann::ordered_json to_json(const QualitySummary& quality);
nlohmann::ordered_json to_json(const VerifyReport& verified);
nlohmann::ordered_json to_json(const Error& error);
nlohmann::ordered_json to_json(const Vec3& p);
nlohmann::ordered_json to_json(const Box3& box);

/// The first fields of every report.
nlohmann::ordered_json json_head(const std::string& command, ExitCode exit_code);

}  // namespace unsliver::cli
