/// \file
/// What a Gmsh file says of a periodic mesh: which nodes of one piece of its surface are copies of which
/// nodes of another.
#pragma once

#include <utility>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// The triangles labelled `label` are copies of those labelled `master`, moved.
struct PeriodicFaces {
  int label, master;
  Vec3 moved;
  std::vector<std::pair<VertexId, VertexId>> nodes;  ///< of the copy, and of the master; ascending
};

/// One for each label above 14 that occurs (unsliver/mesh.hpp); none for a mesh that is not periodic or whose
/// triangles are not labelled so.
std::vector<PeriodicFaces> periodic_faces(const TetMesh& mesh);

}  // namespace unsliver::io
