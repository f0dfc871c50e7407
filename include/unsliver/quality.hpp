/// \file
/// Quality of a tetrahedral mesh, anybody's: extremes, histogram, counts, worst elements. Reports only, in
/// doubles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver {

struct WorstTet {
  std::size_t tet = 0;
  double min_dihedral_deg = 0, max_dihedral_deg = 0, radius_edge = 0;
  Tet corners;
};

struct QualitySummary {
  std::size_t tets = 0;
  double min_dihedral_deg = 180, max_dihedral_deg = 0, max_radius_edge = 0;
  double volume = 0;                   ///< sum of absolute volumes
  std::size_t inverted = 0, flat = 0;  ///< by the sign of the volume in doubles
  /// All dihedral angles (6 a tetrahedron) in bins [5i, 5i + 5), but 135 counts below 135, within what is
  /// guaranteed, and 180 falls in the last one. Here and in the
  /// counts below, an angle within 1e-9 degrees of a limit counts as equal to it.
  std::array<std::uint64_t, 36> histogram{};
  std::array<std::uint64_t, 5> below{};  ///< tetrahedra with a dihedral angle below 5, 10, 15, 20, 30 degrees
  std::uint64_t outside_30_135 = 0;      ///< tetrahedra with an angle outside [30, 135]
  std::vector<WorstTet> worst;           ///< by smallest dihedral angle, at most `worst_count`
};

/// O(tets). Ids index mesh.tets; `worst` is sorted, ties by id. max_radius_edge is infinite where a
/// tetrahedron is flat. Requires finite points and valid indices.
QualitySummary summarize_quality(const TetMesh& mesh, std::size_t worst_count = 5);

/// Smallest dihedral angle of each tetrahedron in degrees, for output arrays.
std::vector<float> min_dihedral_angles_deg(const TetMesh& mesh);

}  // namespace unsliver
