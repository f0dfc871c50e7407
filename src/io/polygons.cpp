#include "io/polygons.hpp"

#include "io/fail.hpp"

namespace unsliver::io {

void add_polygon(std::span<const VertexId> corners, const Scanner& place, TriangleMesh& mesh) {
  if (corners.size() < 3)
    place.fail_here(ErrorCode::kFormat,
                    fmt::format("it has {} corners, but a face needs at least 3", corners.size()));
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

void require_numberable(std::size_t vertex_count, const Scanner& place) {
  if (vertex_count >= kNoVertex)
    place.fail_here(ErrorCode::kLimit,
                    fmt::format("{} vertices are more than a mesh can number", vertex_count));
}

void require_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    fail(ErrorCode::kBadInput, "{}: the file has no triangles; a surface is needed", mesh.name);
}

}  // namespace unsliver::io
