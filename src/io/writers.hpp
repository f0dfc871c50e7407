/// \file
/// Writers of formats. All require a consistent mesh (require_consistent); contracts: unsliver/io.hpp.
#pragma once

#include <filesystem>
#include <span>

#include "unsliver/io_arrays.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// `min_dihedral_deg`: one per tetrahedron or empty. `point_arrays`: more data, one row a point.
void write_vtu(const std::filesystem::path& path, const TetMesh& mesh,
               std::span<const float> min_dihedral_deg, std::span<const NamedArray> point_arrays = {});
void write_msh22(const std::filesystem::path& path, const TetMesh& mesh, bool ascii);
/// Elements are grouped by region, as the format demands; the order within a region is kept.
void write_msh41(const std::filesystem::path& path, const TetMesh& mesh, bool ascii);
void write_medit(const std::filesystem::path& path, const TetMesh& mesh);
/// Writes STEM.node, STEM.ele and STEM.face, STEM being `path` without extension. Numbers start at 0. A mesh
/// without triangles gets the facets of its boundary, with marker 1 as TetGen's have.
void write_tetgen(const std::filesystem::path& path, const TetMesh& mesh);

}  // namespace unsliver::io
