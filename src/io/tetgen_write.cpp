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

}  // namespace

void write_tetgen(const std::filesystem::path& path, const TetMesh& mesh) {
  Output node(with_extension(path, ".node"));
  Output ele(with_extension(path, ".ele"));
  Output face(with_extension(path, ".face"));
  write_nodes(node, mesh);
  ele.print(mesh.tets.size(), " 4 ", mesh.regions.empty() ? 0 : 1, "\n");
  write_elements(ele, mesh.tets, mesh.regions);
  face.print(mesh.triangles.size(), " ", mesh.triangle_labels.empty() ? 0 : 1, "\n");
  write_elements(face, mesh.triangles, mesh.triangle_labels);
  node.commit();
  ele.commit();
  face.commit();
}

}  // namespace unsliver::io
