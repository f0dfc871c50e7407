#include "refine/extract.hpp"
#include "refine/figure_5.hpp"
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

}  // namespace

MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, const MeshOptions& options,
                       const Control& control) {
  MeshResult result;
  refine::Refinement refinement(domain, sizing, options, control);
  try {
    if (options.strategy == Strategy::kLiteral)
      refine::figure_5_literal(refinement);
    else
      refine::figure_5_thrifty(refinement);
  } catch (const refine::Stopped& stopped) {
    result.status = stopped.status;
  }
  refinement.enter_phase("extract");
  result.mesh = refine::extract_superset(refinement);
  refinement.finish_phases();
  result.stats = refinement.stats();
  copy_counts(refinement, result.stats);
  return result;
}

}  // namespace unsliver
