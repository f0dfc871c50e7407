/// \file
/// The steps from a domain and a size to a mesh that is judged: what the program and the Python package
/// share. No terminal, no files. Each step fills in its part of the report.
#pragma once

#include <span>

#include "mesh_report.hpp"
#include "unsliver/progress.hpp"

namespace unsliver::cli {

/// The options as applied: without a cap of the user's the memory available is the cap, for better ended than
/// killed.
void add_options(MeshReport& report, const MeshOptions& asked);

/// Requires options and source. Sets size and estimate. \throws Error.
void plan_mesh(MeshReport& report, const SizeRequest& size);

/// "about 1,000 vertices, ...". Requires a plan, as all that follows.
std::string expected_text(const SizeEstimate& estimate);

/// \throws Error kLimit where the estimate is so far beyond a cap that there is no use to start.
void check_estimate(const MeshReport& report, const MeshOptions& asked);

/// \throws Error.
MeshResult make_mesh(MeshReport& report, const Control& control);

/// How a run ended.
void add_outcome(MeshReport& report, MeshStatus status, const MeshStats& stats);
void add_counts(MeshReport& report, const TetMesh& mesh);

/// Holds the mesh to all that it promises, by the independent checker.
void judge_mesh(MeshReport& report, const MeshResult& result, const Control& control);

/// Draws the conclusions from report.verified and report.quality; no verdict remains where the check was
/// interrupted.
void conclude(MeshReport& report, bool interrupted);

/// The limits that the mesh of the options must keep.
QualityLimits limits_of(const MeshOptions& options);

}  // namespace unsliver::cli
