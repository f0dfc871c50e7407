/// \file
/// TetGen .node, .ele and .face.
#include "io/output.hpp"
#include "io/writers.hpp"

namespace unsliver::io {
namespace {

std::filesystem::path with_extension(std::filesystem::path path, const char* extension) {
  return path.replace_extension(extension);
}

void write_nodes(Output& out, const TetMesh& mesh) {
  out.print(mesh.points.size(), " 3 0 0\n");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3& p = mesh.points[i];
    out.print(i, " ", p.x, " ", p.y, " ", p.z, "\n");
  }
}

template <std::size_t N>
void write_elements(Output& out, const std::vector<std::array<VertexId, N>>& elements,
                    const std::vector<std::int32_t>& labels) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    out.put(i);
    for (const VertexId v : elements[i]) out.print(" ", v);
    if (!labels.empty()) out.print(" ", labels[i]);
    out.put('\n');
  }
}

void write_faces(Output& out, const std::vector<std::array<VertexId, 3>>& triangles,
                 const std::vector<std::int32_t>& labels) {
  out.print(triangles.size(), " ", labels.empty() ? 0 : 1, "\n");
  write_elements(out, triangles, labels);
}

// TetGen marks what lies on the boundary with 1 where the user gave no markers.
void write_boundary(Output& out, const TetMesh& mesh) {
  const auto facets = boundary_facets(mesh);
  write_faces(out, facets, std::vector<std::int32_t>(facets.size(), 1));
}

}  // namespace

void write_tetgen(const std::filesystem::path& path, const TetMesh& mesh) {
  Output node(with_extension(path, ".node"));
  Output ele(with_extension(path, ".ele"));
  Output face(with_extension(path, ".face"));
  write_nodes(node, mesh);
  ele.print(mesh.tets.size(), " 4 ", mesh.regions.empty() ? 0 : 1, "\n");
  write_elements(ele, mesh.tets, mesh.regions);
  if (mesh.triangles.empty())
    write_boundary(face, mesh);
  else
    write_faces(face, mesh.triangles, mesh.triangle_labels);
  node.commit();
  ele.commit();
  face.commit();
}

}  // namespace unsliver::io
