#include "unsliver/refine.hpp"

namespace unsliver {
namespace {

/// Up to this Lipschitz constant of s the octree's vertices are at most 1.12 times those of closure
/// (measured: docs/CLOSURE.md).
constexpr double kSlowGrading = 0.05;

bool is_relaxed(const MeshOptions& options) {
  const MeshOptions strictest;
  return options.min_dihedral_deg < strictest.min_dihedral_deg ||
         options.max_dihedral_deg > strictest.max_dihedral_deg ||
         options.max_radius_edge > least_radius_edge(false);
}

}  // namespace

const char* to_string(Strategy strategy) {
  switch (strategy) {
    case Strategy::kAuto:
      return "auto";
    case Strategy::kLiteral:
      return "literal";
    case Strategy::kThrifty:
      return "thrifty";
    case Strategy::kClosure:
      return "closure";
    case Strategy::kOctree:
      return "octree";
  }
  return "unknown";
}

StrategyChoice choose_strategy(const MeshOptions& options, const Sizing& sizing, bool with_input_vertices) {
  if (options.strategy != Strategy::kAuto) return {options.strategy, "asked for"};
  if (with_input_vertices) return {Strategy::kThrifty, "the one with fewest vertices beside points"};
  if (sizing.lipschitz() == 0) return {Strategy::kOctree, "fastest, and thrifty for a constant size"};
  if (sizing.lipschitz() <= kSlowGrading) return {Strategy::kOctree, "fastest, and the size varies slowly"};
  if (is_relaxed(options)) return {Strategy::kThrifty, "uses the relaxed limits to save vertices"};
  return {Strategy::kClosure, "fewest vertices where the size varies"};
}

}  // namespace unsliver
