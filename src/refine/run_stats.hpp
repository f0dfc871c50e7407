/// \file
/// What every run reports of its kernel and promises of its mesh.
#pragma once

#include "refine/criteria.hpp"
#include "unsliver/mesh.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::refine {

/// Kernel: see LabelledMesh.
template <class Kernel>
void copy_counts(const Kernel& mesh, MeshStats& stats) {
  const auto& counts = mesh.counts();
  stats.insphere_filter = counts.conflict.filter;
  stats.insphere_small = counts.conflict.small;
  stats.insphere_wide = counts.conflict.wide;
  stats.insphere_tie = counts.conflict.tie;
  stats.orient_filter = counts.orient.filter;
  stats.orient_small = counts.orient.small;
  stats.orient_wide = counts.orient.wide;
  stats.total_vertices = mesh.vertex_count();
  stats.total_tets = mesh.tet_count();
}

inline QualityLimits limits_of(const MeshOptions& options, bool with_input_vertices) {
  return {options.min_dihedral_deg, options.max_dihedral_deg, max_radius_edge(options, with_input_vertices)};
}

}  // namespace unsliver::refine
