#include "octree/box_faces.hpp"

#include <bit>

namespace unsliver::octree {
namespace {

/// The corners of the facet opposite to each corner, outward.
constexpr std::array<std::array<std::size_t, 3>, 4> kFacets = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The faces that a point lies on, bit label - 1 each.
unsigned faces_at(const Box3& box, const Vec3& p) {
  unsigned faces = 0;
  for (int axis = 0; axis < 3; ++axis) {
    faces |= unsigned(p[axis] == box.lo[axis]) << 2 * axis;
    faces |= unsigned(p[axis] == box.hi[axis]) << (2 * axis + 1);
  }
  return faces;
}

}  // namespace

void mark_faces(const Box3& box, TetMesh& mesh) {
  std::vector<std::uint8_t> faces;
  faces.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) faces.push_back(std::uint8_t(faces_at(box, p)));
  for (const auto& t : mesh.tets)
    for (const auto& [a, b, c] : kFacets) {
      const unsigned shared = faces[t[a]] & faces[t[b]] & faces[t[c]];
      if (shared == 0) continue;
      mesh.triangles.push_back({t[a], t[b], t[c]});
      mesh.triangle_labels.push_back(1 + std::countr_zero(shared));
    }
}

}  // namespace unsliver::octree
