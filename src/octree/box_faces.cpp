#include "octree/box_faces.hpp"

#include <algorithm>
#include <bit>

#include "octree/parallel.hpp"

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

/// The facets found among some tetrahedra in a row.
struct Marked {
  std::vector<std::array<VertexId, 3>> triangles;
  std::vector<std::int32_t> labels;

  /// `faces`: faces_at of all vertices.
  void mark(const std::array<VertexId, 4>& t, const std::vector<std::uint8_t>& faces) {
    const std::array<unsigned, 4> at = {faces[t[0]], faces[t[1]], faces[t[2]], faces[t[3]]};
    if ((at[0] | at[1] | at[2] | at[3]) == 0) return;
    for (const auto& [a, b, c] : kFacets) {
      const unsigned shared = at[a] & at[b] & at[c];
      if (shared == 0) continue;
      triangles.push_back({t[a], t[b], t[c]});
      labels.push_back(1 + std::countr_zero(shared));
    }
  }
};

constexpr std::size_t kRow = 1 << 16;

/// Calls work(number of the row, its first index, its end) for rows of kRow of n things.
template <class Work>
void for_each_row(std::size_t n, unsigned threads, const Work& work) {
  for_each_task((n + kRow - 1) / kRow, threads,
                [&](std::size_t row, unsigned) { work(row, row * kRow, std::min(n, (row + 1) * kRow)); });
}

}  // namespace

void mark_faces(const Box3& box, TetMesh& mesh, unsigned threads) {
  std::vector<std::uint8_t> faces(mesh.points.size());
  for_each_row(faces.size(), threads, [&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) faces[v] = std::uint8_t(faces_at(box, mesh.points[v]));
  });
  std::vector<Marked> rows(mesh.tets.size() / kRow + 1);
  for_each_row(mesh.tets.size(), threads, [&](std::size_t row, std::size_t first, std::size_t end) {
    for (std::size_t t = first; t < end; ++t) rows[row].mark(mesh.tets[t], faces);
  });
  for (const auto& [triangles, labels] : rows) {
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    mesh.triangle_labels.insert(mesh.triangle_labels.end(), labels.begin(), labels.end());
  }
}

}  // namespace unsliver::octree
