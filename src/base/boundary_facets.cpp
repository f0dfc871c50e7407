#include <algorithm>

#include "unsliver/mesh.hpp"

namespace unsliver {
namespace {

using Triangle = std::array<VertexId, 3>;

/// 16 bytes each: there are four a tetrahedron. The corners as they are turned are looked up again.
struct Facet {
  Triangle sorted;
  std::uint32_t tet;
};

bool is_inverted(const Tet& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) < 0; }

std::array<Triangle, 4> outward_facets(const TetMesh& mesh, std::size_t t) {
  auto [a, b, c, d] = mesh.tets[t];
  if (is_inverted(mesh.corners(t))) std::swap(c, d);
  return {{{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}};
}

Triangle sorted(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

Triangle outward(const TetMesh& mesh, const Facet& facet) {
  const auto facets = outward_facets(mesh, facet.tet);
  return *std::find_if(facets.begin(), facets.end(),
                       [&](const Triangle& triangle) { return sorted(triangle) == facet.sorted; });
}

/// All facets, equal ones side by side.
std::vector<Facet> sorted_facets(const TetMesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Triangle& triangle : outward_facets(mesh, t))
      facets.push_back({sorted(triangle), static_cast<std::uint32_t>(t)});
  std::sort(facets.begin(), facets.end(), [](const Facet& f, const Facet& g) { return f.sorted < g.sorted; });
  return facets;
}

}  // namespace

std::vector<Triangle> boundary_facets(const TetMesh& mesh) {
  const std::vector<Facet> facets = sorted_facets(mesh);
  std::vector<Triangle> boundary;
  for (auto f = facets.begin(); f != facets.end();) {
    const auto next = std::find_if(f, facets.end(), [&](const Facet& g) { return g.sorted != f->sorted; });
    if (next - f == 1) boundary.push_back(outward(mesh, *f));
    f = next;
  }
  return boundary;
}

}  // namespace unsliver
