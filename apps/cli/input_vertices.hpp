/// \file
/// The points that a user wants as vertices of the mesh.
#pragma once

#include <string>
#include <vector>

#include "unsliver/error.hpp"
#include "unsliver/mesh.hpp"
#include "unsliver/points.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::cli {

struct InputVertices {
  std::string file;
  PointSet set;
  std::vector<VertexId> ids;  ///< of each point in the file; empty where none was left out: its index

  std::size_t count() const { return set.points.size(); }
};

/// \throws Error.
InputVertices read_input_vertices(const std::string& path);

/// The bounding box of some points (at least one, all finite). Sides of no length are given that of the
/// longest one (1 where all points coincide), and a sentence that says so is added to `notes`.
Box3 box_with_volume(const std::vector<Vec3>& points, std::vector<std::string>& notes);

/// Is each input a vertex of a tetrahedron, bit for bit, and named by point_source? A line and findings
/// "input" for the report. Requires a mesh whose indices are valid, with point_source in terms of `inputs`.
void check_inputs(const TetMesh& mesh, const std::vector<Vec3>& inputs, VerifyReport& report);

/// From indices of the points to ids of the file.
void restore_ids(const InputVertices& inputs, TetMesh& mesh);
Error with_restored_ids(const InputVertices& inputs, const Error& error);

}  // namespace unsliver::cli
