/// \file
/// The picture of a mesh: its cut view, a colour legend and the histogram of its dihedral angles.
#pragma once

#include <optional>
#include <string>

#include "cut.hpp"
#include "image.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::cli {

struct PictureOptions {
  int width = 1200, height = 900;
  std::optional<CutPlane> cut;
  Vec3 up{0, 0, 1};
  std::string title;
};

/// Requires at least one tetrahedron with finite corners.
Image draw_picture(const TetMesh& mesh, const PictureOptions& options);

}  // namespace unsliver::cli
