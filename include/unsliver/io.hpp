/// \file
/// Files in and out. Formats are told by extension, and checked against the content.
///
/// Every reader reports errors as Error with kFormat, kBadInput or kIo whose message names the file, the line
/// (or byte offset for binary formats), the element and its coordinates. Every writer writes to a temporary
/// name in the same directory and renames it at the end; on failure nothing is left behind and an existing
/// file is untouched.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/points.hpp"

namespace unsliver::io {

/// STL (ASCII, binary), OBJ, OFF, PLY (ASCII, binary little and big endian). Polygons are fanned into
/// triangles. STL corners that are equal bit for bit are merged. Coordinates are kept bit for bit. NaN,
/// infinities, indices out of range, truncated files and files without triangles are errors.
TriangleMesh read_surface(const std::filesystem::path& path);

/// VTU (ours: appended raw, zlib or none; meshio's: ASCII, inline base64 with and without zlib; appended
/// base64), Gmsh .msh 2.2 and 4.1 (ASCII and binary), MEDIT .mesh (ASCII), TetGen (.node or .ele, its partner
/// beside it). Tetrahedra only; triangles become `triangles`; other element kinds are skipped. Region and
/// label arrays are kept where the format has them.
TetMesh read_tet_mesh(const std::filesystem::path& path);

/// The points of a file, in its order, duplicates included (but STL corners that are equal are one point):
/// - XYZ: lines "x y z", or the chemists' form (the number of atoms, a comment line, "element x y z ...").
/// - CSV, separated by commas, semicolons or tabs: columns by the names of a header (x, y, z, and size,
/// radius
///   or s; others are noted and skipped), or without one 3 or 4 columns, the fourth being the size.
/// - PQR: ATOM and HETATM records, fields separated by blanks; radii are sizes.
/// - TetGen .node (.ele and .face name the .node beside them); attributes are skipped.
/// - The vertices of any surface or tetrahedral mesh that is read here; it may have no triangles or
/// tetrahedra. Files without points, numbers that are not finite, sizes that are not positive and rows with
/// too few or too many columns are errors.
PointSet read_points(const std::filesystem::path& path);

/// VTU (appended raw, zlib; arrays level, point_source, region, min_dihedral as far as present), Gmsh .msh
/// (2.2 binary or ASCII, 4.1), MEDIT .mesh, TetGen .node/.ele/.face (path with any of these extensions writes
/// all three; .face holds `triangles`, or where there are none the boundary facets).
struct WriteOptions {
  std::string format;                   ///< "" = by extension; "vtu", "msh22", "msh41", "medit", "tetgen"
  bool ascii = false;                   ///< msh only: text instead of binary
  std::vector<float> min_dihedral_deg;  ///< per tetrahedron or empty: written to VTU
};
void write_tet_mesh(const std::filesystem::path& path, const TetMesh& mesh, const WriteOptions& options = {});

/// A background sizing mesh: MEDIT .mesh with .sol beside it, or TetGen .node/.ele with .mtr beside it.
NodalField read_sizing_mesh(const std::filesystem::path& path);

/// Names of formats that can be read or written, for help texts: {"stl", "obj", ...}.
std::vector<std::string> surface_formats();
std::vector<std::string> tet_mesh_formats();
/// Those that hold points alone: {"xyz", "csv", "pqr", "node"}.
std::vector<std::string> point_formats();

}  // namespace unsliver::io
