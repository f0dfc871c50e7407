#include "generator_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "unsliver/error.hpp"

namespace unsliver::cli {
namespace {

/// `value` must lie between `loosest` and `strictest`, in either order; NaN does not.
void check_bound(const char* option, double value, double strictest, double loosest) {
  const double low = std::min(strictest, loosest), high = std::max(strictest, loosest);
  if (low <= value && value <= high && value != loosest) return;
  throw Error(ErrorCode::kBadOption,
              fmt::format("{} is {}: it must lie between {} and {} ({} is the strictest that is proven)",
                          option, value, low, high, strictest));
}

/// Boxes are filled exactly by octrees alone.
void check_conforming(const std::string& name, const RunKind& run) {
  if (!run.conform) return;
  if (run.keep_partial)
    throw Error(ErrorCode::kBadOption,
                "--keep-partial has no effect with --conform, which has no mesh until its end");
  if (name != "auto" && name != "octree")
    throw Error(
        ErrorCode::kBadOption,
        fmt::format("--strategy {} does not fill a box exactly, its tetrahedra reach beyond: --conform "
                    "goes with octree",
                    name));
}

Strategy named_strategy(const std::string& name) {
  for (const Strategy strategy :
       {Strategy::kAuto, Strategy::kThrifty, Strategy::kLiteral, Strategy::kClosure, Strategy::kOctree})
    if (name == to_string(strategy)) return strategy;
  throw Error(ErrorCode::kBadOption,
              fmt::format("--strategy is \"{}\": use auto, thrifty, literal, closure or octree", name));
}

}  // namespace

void check_angles(const MeshOptions& mesh) {
  const MeshOptions proven;
  check_bound("--min-angle", mesh.min_dihedral_deg, proven.min_dihedral_deg, 0);
  check_bound("--max-angle", mesh.max_dihedral_deg, proven.max_dihedral_deg, 180);
}

double radius_edge_bound(const std::optional<double>& typed, bool with_inputs) {
  const double least = least_radius_edge(with_inputs);
  if (!typed || *typed >= least) return typed.value_or(least);
  throw Error(ErrorCode::kBadOption,
              fmt::format("--max-radius-edge is {}: no less than {} is proven", *typed,
                          with_inputs ? "1.368, beside points," : fmt::format("{} (sqrt(5)/2)", least)));
}

Strategy strategy_of(const std::string& name, const RunKind& run) {
  check_conforming(name, run);
  const Strategy strategy = named_strategy(name);
  if (strategy == Strategy::kOctree && run.keep_partial && !run.has_inputs)
    throw Error(ErrorCode::kBadOption,
                "--keep-partial has no effect with --strategy octree and no points: there is no mesh until "
                "its end");
  if (strategy == Strategy::kClosure && run.has_inputs)
    throw Error(ErrorCode::kBadOption, "--strategy closure knows no points: use thrifty, octree or literal");
  return strategy == Strategy::kAuto && run.keep_partial ? Strategy::kThrifty : strategy;
}

}  // namespace unsliver::cli
