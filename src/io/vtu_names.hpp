/// \file
/// Names and numbers that the VTU reader and writer agree on.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace unsliver::io {

inline constexpr std::int64_t kVtkTriangle = 5;
inline constexpr std::int64_t kVtkTetra = 10;

inline constexpr std::string_view kVtuLevel = "level";
inline constexpr std::string_view kVtuPointSource = "point_source";
inline constexpr std::string_view kVtuRegion = "region";
inline constexpr std::string_view kVtuMinDihedral = "min_dihedral";
/// Field data: unit, then origin x, y, z.
inline constexpr std::string_view kVtuFrame = "unsliver_frame";
/// Field data: the smallest and the largest dihedral angle in degrees and the radius-edge ratio guaranteed.
inline constexpr std::string_view kVtuLimits = "unsliver_limits";

/// Of periodic meshes. Point data: the point in the cell that this one is a copy of, or itself, and how many
/// periods away it is along each axis. Field data: the cell's corners.
inline constexpr std::string_view kVtuHome = "periodic_home";
inline constexpr std::string_view kVtuShift = "periodic_shift";
inline constexpr std::string_view kVtuCell = "unsliver_periodic_cell";

/// Where region labels are looked for: ours first, then what meshio calls those of other formats.
inline constexpr std::array<std::string_view, 4> kVtuRegionNames{kVtuRegion, "gmsh:physical", "medit:ref",
                                                                 "tetgen:ref"};

}  // namespace unsliver::io
