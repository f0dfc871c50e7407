#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "octree/octree.hpp"
#include "refine/criteria.hpp"
#include "refine/extract.hpp"
#include "refine/figure_8_octree.hpp"
#include "refine/figures.hpp"
#include "refine/octree_run.hpp"
#include "refine/refinement.hpp"
#include "refine/run_stats.hpp"
#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/stream.hpp"

namespace unsliver {

const char* to_string(MeshStatus status) {
  switch (status) {
    case MeshStatus::kDone:
      return "done";
    case MeshStatus::kTetCap:
      return "tet_cap";
    case MeshStatus::kMemoryCap:
      return "memory_cap";
    case MeshStatus::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

namespace {

/// Some more tetrahedra count as meeting the domain: closure knows no bad ones, and balls keep their
/// vertices.
void run_again(refine::Refinement& r, Strategy strategy) {
  if (strategy == Strategy::kLiteral) return refine::run(r, strategy);
  if (strategy == Strategy::kClosure) return;
  r.inputs().empty() ? refine::figure_5_quality(r) : refine::figure_8_quality(r);
}

MeshStatus status_after(void (&work)(refine::Refinement&, Strategy), refine::Refinement& r,
                        Strategy strategy) {
  try {
    work(r, strategy);
    return MeshStatus::kDone;
  } catch (const refine::Stopped& stopped) {
    return stopped.status;
  }
}

refine::Extraction enter_extraction(refine::Refinement& r) {
  r.enter_phase("extract");
  return refine::Extraction(r);
}

std::vector<std::string> notes_on_inputs(const refine::Refinement& r) {
  std::vector<std::string> notes;
  if (const std::string merged = r.inputs().sites().note(); !merged.empty()) notes.push_back(merged);
  if (r.outside_count() > 0)
    notes.push_back(
        fmt::format("{} of {} input vertices lie outside the domain; the tetrahedra around them are part of "
                    "the mesh",
                    r.outside_count(), r.inputs().places().size()));
  return notes;
}

/// What the kernel holds, finished or not. The phase is that of the extraction.
MeshResult result_of(refine::Refinement& refinement, MeshStatus status,
                     const refine::Extraction& extraction) {
  MeshResult result;
  result.status = status;
  result.notes = notes_on_inputs(refinement);
  result.mesh = refine::extract_superset(refinement, extraction);
  refinement.finish_phases();
  result.stats = refinement.stats();
  refine::copy_counts(refinement.mesh(), result.stats);
  return result;
}

MeshResult mesh_by_refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                              const MeshOptions& options, const Control& control) {
  refine::Refinement refinement(domain, sizing, inputs, options, control);
  MeshStatus status = status_after(refine::run<refine::Refinement>, refinement, options.strategy);
  refine::Extraction extraction = enter_extraction(refinement);
  while (status == MeshStatus::kDone && refine::want_dropped_proofs(refinement, extraction)) {
    status = status_after(run_again, refinement, options.strategy);
    extraction = enter_extraction(refinement);
  }
  return result_of(refinement, status, extraction);
}

MeshResult mesh_by_octree(const Domain& domain, const Sizing& sizing, const MeshOptions& options,
                          const Control& control) {
  refine::quality_bounds(options, false);  // refuses what no theorem backs
  const octree::OctreeOptions limits = refine::octree_options(options);
  return refine::result_of(octree::mesh_domain_octree(domain, sizing, limits, control), limits);
}

/// Beyond the domain's box there may be no vertices of the forest to build upon.
void require_inputs_in_box(const Domain& domain, std::span<const Vec3> inputs) {
  const Box3 box = domain.bounds();
  const auto outside =
      std::find_if_not(inputs.begin(), inputs.end(), [&](const Vec3& p) { return box.contains(p); });
  if (outside == inputs.end()) return;
  throw Error(
      ErrorCode::kBadOption,
      fmt::format("input vertex {} at ({}, {}, {}) lies outside the domain's box: the octree strategy "
                  "needs it inside, use thrifty",
                  outside - inputs.begin(), outside->x, outside->y, outside->z));
}

/// A run that is ended early has the input vertices and what the kernel holds around them.
MeshResult mesh_by_octree(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                          const MeshOptions& options, const Control& control) {
  require_inputs_in_box(domain, inputs);
  const octree::OctreeOptions limits = refine::octree_options(options);
  refine::Refinement refinement(domain, sizing, inputs, options, control);
  MeshResult result;
  try {
    result =
        refine::result_of(refine::figure_8_on_octree(refinement, domain, sizing, limits, control), limits);
  } catch (const refine::Stopped& stopped) {
    result.status = stopped.status;
  }
  if (result.status != MeshStatus::kDone)
    return result_of(refinement, result.status, enter_extraction(refinement));
  result.notes = notes_on_inputs(refinement);
  const MeshStats& stats = refinement.stats();
  result.stats.size_insertions = stats.size_insertions;
  result.stats.quality_insertions = stats.quality_insertions;
  result.stats.figure_8 = stats.figure_8;
  result.stats.candidates = stats.candidates;
  return result;
}

void state_limits(const MeshOptions& options, bool with_input_vertices, MeshResult& result) {
  if (result.status == MeshStatus::kDone)
    result.mesh.limits = refine::limits_of(options, with_input_vertices);
}

/// Nothing to say where the lattice is as asked (`radius` <= `asked`), or the size varies (`radius` 0).
void note_lattice(double asked, double radius, MeshResult& result) {
  constexpr double kWorthTelling = 1.01;
  if (radius == 0 || asked < kWorthTelling * radius) return;
  result.notes.push_back(fmt::format(
      "the box's sides fix the lattice: its largest empty ball has radius {:.6g} where {:.6g} was "
      "asked, so the mesh is {:.2f} times as fine",
      radius, asked, asked / radius));
}

}  // namespace

MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, const MeshOptions& options,
                       const Control& control) {
  return mesh_domain(domain, sizing, {}, options, control);
}

MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                       const MeshOptions& options, const Control& control) {
  MeshOptions resolved = options;
  const StrategyChoice choice = choose_strategy(options, sizing, !inputs.empty());
  resolved.strategy = choice.strategy;
  if (resolved.strategy == Strategy::kClosure && !inputs.empty())
    throw Error(ErrorCode::kBadOption,
                "the closure strategy knows no input vertices: use thrifty or literal");
  const bool octree = resolved.strategy == Strategy::kOctree;
  MeshResult result = !octree          ? mesh_by_refinement(domain, sizing, inputs, resolved, control)
                      : inputs.empty() ? mesh_by_octree(domain, sizing, resolved, control)
                                       : mesh_by_octree(domain, sizing, inputs, resolved, control);
  result.stats.strategy = choice.strategy;
  result.stats.strategy_reason = choice.reason;
  state_limits(options, !inputs.empty(), result);
  return result;
}

StreamResult stream_domain(const Domain& domain, const Sizing& sizing, MeshSink& sink,
                           const MeshOptions& options, const Control& control) {
  const StrategyChoice choice = choose_strategy(options, sizing, false);
  if (choice.strategy != Strategy::kOctree)
    throw Error(ErrorCode::kBadOption,
                fmt::format("only the octree strategy makes meshes piece by piece, this is {} ({})",
                            to_string(choice.strategy), choice.reason));
  refine::quality_bounds(options, false);  // refuses what no theorem backs
  const octree::OctreeOptions limits = refine::octree_options(options);
  octree::OctreeResult made = octree::stream_domain_octree(domain, sizing, sink, limits, control);
  StreamResult result;
  result.vertices = made.stats.vertices;
  result.tets = made.stats.needed_tets;
  MeshResult meshed = refine::result_of(std::move(made), limits);
  result.status = meshed.status;
  result.limits = refine::limits_of(options, false);
  result.stats = std::move(meshed.stats);
  result.stats.total_vertices = result.vertices;
  result.stats.total_tets = result.tets;
  result.stats.strategy = choice.strategy;
  result.stats.strategy_reason = choice.reason;
  return result;
}

MeshResult mesh_box(const Box3& box, const Sizing& sizing, const MeshOptions& options,
                    const Control& control) {
  if (options.strategy != Strategy::kAuto && options.strategy != Strategy::kOctree)
    throw Error(ErrorCode::kBadOption, fmt::format("the {} strategy cannot fill a box exactly: use octree",
                                                   to_string(options.strategy)));
  refine::quality_bounds(options, false);  // refuses what no theorem backs
  const octree::OctreeOptions limits = refine::octree_options(options);
  octree::OctreeResult made = octree::mesh_box_octree(box, sizing, limits, control);
  const double radius = made.stats.radius;
  MeshResult result = refine::result_of(std::move(made), limits);
  note_lattice(sizing.at(box.center()), radius, result);
  result.stats.strategy = Strategy::kOctree;
  result.stats.strategy_reason = "the box is to be filled exactly";
  state_limits(options, false, result);
  return result;
}

}  // namespace unsliver
