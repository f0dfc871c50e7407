#include "cut.hpp"

#include <algorithm>
#include <tuple>

#include "text.hpp"
#include "unsliver/error.hpp"

namespace unsliver::cli {
namespace {

struct Face {
  std::array<VertexId, 3> key;  ///< ascending
  std::uint32_t tet;
};

std::vector<Face> all_faces(const TetMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      Face face{{}, static_cast<std::uint32_t>(t)};
      for (std::size_t i = 0; i < 3; ++i) face.key[i] = mesh.tets[t][(opposite + 1 + i) % 4];
      std::sort(face.key.begin(), face.key.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return std::tie(a.key, a.tet) < std::tie(b.key, b.tet); });
  return faces;
}

std::vector<bool> remaining(const TetMesh& mesh, const std::optional<CutPlane>& cut) {
  std::vector<bool> kept(mesh.tets.size(), true);
  if (!cut) return kept;
  for (std::size_t t = 0; t < kept.size(); ++t) {
    const Tet corners = mesh.corners(t);
    const Vec3 centroid = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    kept[t] = dot(cut->normal, centroid) <= cut->offset;
  }
  return kept;
}

}  // namespace

CutPlane middle_plane(const Box3& box) {
  const Vec3 size = box.size();
  int shortest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (size[axis] < size[shortest]) shortest = axis;
  CutPlane plane;
  plane.normal[shortest] = 1;
  plane.offset = box.center()[shortest];
  return plane;
}

CutPlane parse_plane(const std::string& text) {
  const auto n = parse_numbers(text, 4, "--cut");
  const CutPlane plane{{n[0], n[1], n[2]}, n[3]};
  if (!is_finite(plane.normal) || norm(plane.normal) == 0)
    throw Error(ErrorCode::kBadOption, "--cut \"" + text + "\": the normal must be finite and not zero");
  return plane;
}

std::vector<VisibleFace> visible_faces(const TetMesh& mesh, const std::optional<CutPlane>& cut) {
  const std::vector<bool> kept = remaining(mesh, cut);
  const std::vector<Face> faces = all_faces(mesh);
  std::vector<VisibleFace> visible;
  for (auto begin = faces.begin(); begin != faces.end();) {
    const auto end = std::find_if(begin, faces.end(), [&](const Face& f) { return f.key != begin->key; });
    const auto remains = [&](const Face& f) { return kept[f.tet]; };
    if (std::count_if(begin, end, remains) == 1)
      visible.push_back({begin->key, std::find_if(begin, end, remains)->tet, end - begin > 1});
    begin = end;
  }
  return visible;
}

}  // namespace unsliver::cli
