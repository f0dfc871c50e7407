/// \file
/// A mesh cut open: the whole tetrahedra on one side of a plane, and the faces that can be seen of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::cli {

/// Tetrahedra whose centroid x has dot(normal, x) > offset are taken away.
struct CutPlane {
  Vec3 normal;
  double offset = 0;
};

/// Through the middle of the mesh's box, across its shortest side: the largest view of the interior.
CutPlane middle_plane(const Box3& box);

/// "nx ny nz d". \throws Error kBadOption.
CutPlane parse_plane(const std::string& text);

struct VisibleFace {
  std::array<VertexId, 3> vertices;
  std::uint32_t tet;
  bool inside;  ///< laid bare by the cut, not on the mesh's own boundary
};

/// The faces of exactly one of the tetrahedra that remain.
std::vector<VisibleFace> visible_faces(const TetMesh& mesh, const std::optional<CutPlane>& cut);

}  // namespace unsliver::cli
