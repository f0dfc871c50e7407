#include <fmt/format.h>

#include "octree/fit.hpp"
#include "refine/closure.hpp"
#include "refine/figure_5.hpp"
#include "refine/figure_8.hpp"
#include "refine/periodic_extract.hpp"
#include "refine/run_stats.hpp"
#include "unsliver/error.hpp"
#include "unsliver/periodic.hpp"

namespace unsliver {

namespace {

void run(refine::PeriodicRefinement& r) {
  const bool literal = r.strategy() == Strategy::kLiteral;
  if (r.strategy() == Strategy::kClosure) return refine::closure(r);
  if (r.inputs().empty())
    literal ? refine::figure_5_literal(r) : refine::figure_5_thrifty(r);
  else
    literal ? refine::figure_8_literal(r) : refine::figure_8_thrifty(r);
}

}  // namespace

MeshResult mesh_periodic(const Box3& cell, const Sizing& sizing, std::span<const Vec3> inputs,
                         const MeshOptions& options, const Control& control) {
  MeshOptions resolved = options;
  const StrategyChoice choice = choose_strategy(options, sizing, !inputs.empty());
  resolved.strategy = choice.strategy == Strategy::kOctree ? Strategy::kClosure : choice.strategy;
  if (resolved.strategy == Strategy::kClosure && !inputs.empty())
    throw Error(ErrorCode::kBadOption,
                "the closure strategy knows no input vertices: use thrifty or literal");
  const DomainPtr domain = make_box(cell);
  const octree::BoxLattice lattice = octree::fit_lattice(octree::lattices_of(cell), *domain, sizing);
  const refine::PeriodicWorld place(cell, lattice, inputs);
  refine::PeriodicRefinement refinement(place, sizing, resolved, control);
  MeshResult result;
  try {
    run(refinement);
  } catch (const refine::Stopped& stopped) {
    result.status = stopped.status;
  }
  refinement.enter_phase("extract");
  result.mesh = refine::extract_periodic(refinement);
  refinement.finish_phases();
  result.stats = refinement.stats();
  refine::copy_counts(refinement.mesh(), result.stats);
  result.stats.strategy = resolved.strategy;
  result.stats.strategy_reason = choice.reason;
  if (const std::string merged = refinement.inputs().sites().note(); !merged.empty())
    result.notes.push_back(merged);
  if (result.status == MeshStatus::kDone) result.mesh.limits = refine::limits_of(options, !inputs.empty());
  return result;
}

}  // namespace unsliver
