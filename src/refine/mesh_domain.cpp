#include <fmt/format.h>

#include "refine/extract.hpp"
#include "refine/figure_5.hpp"
#include "refine/figure_8.hpp"
#include "refine/refinement.hpp"
#include "unsliver/refine.hpp"

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

void copy_counts(const refine::Refinement& refinement, MeshStats& stats) {
  const auto& counts = refinement.mesh().counts();
  stats.insphere_filter = counts.conflict.filter;
  stats.insphere_small = counts.conflict.small;
  stats.insphere_wide = counts.conflict.wide;
  stats.insphere_tie = counts.conflict.tie;
  stats.orient_filter = counts.orient.filter;
  stats.orient_small = counts.orient.small;
  stats.orient_wide = counts.orient.wide;
  stats.total_vertices = refinement.mesh().vertex_count();
  stats.total_tets = refinement.mesh().tet_count();
}

void run(refine::Refinement& r, Strategy strategy) {
  const bool literal = strategy == Strategy::kLiteral;
  if (r.inputs().empty())
    literal ? refine::figure_5_literal(r) : refine::figure_5_thrifty(r);
  else
    literal ? refine::figure_8_literal(r) : refine::figure_8_thrifty(r);
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

}  // namespace

MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, const MeshOptions& options,
                       const Control& control) {
  return mesh_domain(domain, sizing, {}, options, control);
}

MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                       const MeshOptions& options, const Control& control) {
  MeshResult result;
  refine::Refinement refinement(domain, sizing, inputs, options, control);
  result.notes = notes_on_inputs(refinement);
  try {
    run(refinement, options.strategy);
  } catch (const refine::Stopped& stopped) {
    result.status = stopped.status;
  }
  refinement.enter_phase("extract");
  result.mesh = refine::extract_superset(refinement, inputs);
  refinement.finish_phases();
  result.stats = refinement.stats();
  copy_counts(refinement, result.stats);
  return result;
}

}  // namespace unsliver
