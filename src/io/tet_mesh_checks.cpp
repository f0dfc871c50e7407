#include "io/tet_mesh_checks.hpp"

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

void require_length(std::size_t length, std::size_t expected, const char* array, const char* elements) {
  if (length != 0 && length != expected)
    fail(ErrorCode::kBadInput, "the mesh's array '{}' has {} entries for {} {}", array, length, expected,
         elements);
}

template <class Element>
void require_valid_indices(const std::vector<Element>& elements, std::size_t vertex_count, const char* kind) {
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const VertexId v : elements[i])
      if (v >= vertex_count)
        fail(ErrorCode::kBadInput, "{} {} of the mesh uses vertex {}, but there are {} vertices", kind, i, v,
             vertex_count);
}

}  // namespace

void require_tets(const TetMesh& mesh, const std::string& name) {
  if (mesh.tets.empty())
    fail(ErrorCode::kBadInput, "{}: the file has no linear tetrahedra (elements of 4 vertices)", name);
}

void require_consistent(const TetMesh& mesh) {
  require_length(mesh.regions.size(), mesh.tets.size(), "regions", "tetrahedra");
  require_length(mesh.levels.size(), mesh.points.size(), "levels", "points");
  require_length(mesh.point_source.size(), mesh.points.size(), "point_source", "points");
  require_length(mesh.triangle_labels.size(), mesh.triangles.size(), "triangle_labels", "triangles");
  require_valid_indices(mesh.tets, mesh.points.size(), "tetrahedron");
  require_valid_indices(mesh.triangles, mesh.points.size(), "triangle");
}

}  // namespace unsliver::io
