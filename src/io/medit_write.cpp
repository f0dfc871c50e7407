/// \file
/// MEDIT .mesh, text.
#include "io/output.hpp"
#include "io/writers.hpp"

namespace unsliver::io {
namespace {

template <std::size_t N>
void write_elements(Output& out, std::string_view keyword,
                    const std::vector<std::array<VertexId, N>>& elements,
                    const std::vector<std::int32_t>& labels) {
  out.print("\n", keyword, "\n", elements.size(), "\n");
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (const VertexId v : elements[i]) out.print(std::uint64_t{v} + 1, " ");
    out.print(labels.empty() ? 0 : labels[i], "\n");
  }
}

}  // namespace

void write_medit(const std::filesystem::path& path, const TetMesh& mesh) {
  Output out(path);
  out.print("MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n", mesh.points.size(), "\n");
  for (const Vec3& p : mesh.points) out.print(p.x, " ", p.y, " ", p.z, " 0\n");
  write_elements(out, "Tetrahedra", mesh.tets, mesh.regions);
  if (!mesh.triangles.empty()) write_elements(out, "Triangles", mesh.triangles, mesh.triangle_labels);
  out.put("\nEnd\n");
  out.commit();
}

}  // namespace unsliver::io
