#include <fmt/format.h>

#include "octree/fit.hpp"
#include "refine/figures.hpp"
#include "refine/octree_run.hpp"
#include "refine/periodic_extract.hpp"
#include "refine/run_stats.hpp"
#include "unsliver/error.hpp"
#include "unsliver/periodic.hpp"

namespace unsliver {

namespace {

MeshResult by_refinement(const refine::PeriodicWorld& place, const Sizing& sizing, const MeshOptions& options,
                         const Control& control) {
  refine::PeriodicRefinement refinement(place, sizing, options, control);
  MeshResult result;
  try {
    refine::run(refinement, refinement.strategy());
  } catch (const refine::Stopped& stopped) {
    result.status = stopped.status;
  }
  refinement.enter_phase("extract");
  result.mesh = refine::extract_periodic(refinement);
  refinement.finish_phases();
  result.stats = refinement.stats();
  refine::copy_counts(refinement.mesh(), result.stats);
  if (const std::string merged = refinement.inputs().sites().note(); !merged.empty())
    result.notes.push_back(merged);
  return result;
}

MeshResult by_octree(const refine::PeriodicWorld& place, const Sizing& sizing, const MeshOptions& options,
                     const Control& control) {
  refine::quality_bounds(options, false);  // refuses what no theorem backs
  const SizingPtr capped = minimum_size({std::make_shared<sizing::Periodic>(sizing, place.cell()),
                                         constant_size(place.largest_size() * place.world().unit())});
  const octree::OctreeOptions limits = refine::octree_options(options);
  MeshResult result = refine::result_of(
      octree::mesh_torus_octree(place.cell(), place.lattice(), *capped, limits, control), limits);
  if (result.status == MeshStatus::kDone)
    result.mesh = refine::unfold_periodic(std::move(result.mesh), place.cell(), place.coarsest_level());
  return result;
}

void require_no_inputs_for(Strategy strategy, std::span<const Vec3> inputs) {
  const bool knows_inputs = strategy == Strategy::kThrifty || strategy == Strategy::kLiteral;
  if (knows_inputs || inputs.empty()) return;
  throw Error(ErrorCode::kBadOption,
              fmt::format("the {} strategy knows no input vertices in periodic cells: use thrifty or literal",
                          to_string(strategy)));
}

}  // namespace

MeshResult mesh_periodic(const Box3& cell, const Sizing& sizing, std::span<const Vec3> inputs,
                         const MeshOptions& options, const Control& control) {
  MeshOptions resolved = options;
  const StrategyChoice choice = choose_strategy(options, sizing, !inputs.empty());
  resolved.strategy = choice.strategy;
  require_no_inputs_for(choice.strategy, inputs);
  const octree::BoxLattice lattice = octree::fit_lattice(octree::lattices_of(cell), *make_box(cell), sizing);
  const refine::PeriodicWorld place(cell, lattice, inputs);
  MeshResult result = choice.strategy == Strategy::kOctree ? by_octree(place, sizing, resolved, control)
                                                           : by_refinement(place, sizing, resolved, control);
  result.stats.strategy = choice.strategy;
  result.stats.strategy_reason = choice.reason;
  if (result.status == MeshStatus::kDone) result.mesh.limits = refine::limits_of(options, !inputs.empty());
  return result;
}

std::vector<Vec3> points_in_cell(const Box3& cell, std::span<const Vec3> points) {
  return refine::PeriodicWorld(cell, octree::lattices_of(cell).front(), points).wrapped();
}

}  // namespace unsliver
