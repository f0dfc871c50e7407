#include "io/boundary_facets.hpp"

#include <algorithm>

namespace unsliver::io {
namespace {

using Triangle = std::array<VertexId, 3>;

/// Its vertices ascend; turned the other way they look outward where `flipped`.
struct Facet {
  Triangle vertices;
  bool flipped;

  bool operator<(const Facet& other) const { return vertices < other.vertices; }
  bool operator==(const Facet& other) const { return vertices == other.vertices; }
  Triangle outward() const {
    const auto [a, b, c] = vertices;
    return flipped ? Triangle{a, c, b} : vertices;
  }
};

bool is_inverted(const Tet& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) < 0; }

Facet sorted_facet(Triangle outward) {
  bool flipped = false;
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
    if (auto& p = outward[std::size_t(i)], &q = outward[std::size_t(j)]; p > q) {
      std::swap(p, q);
      flipped = !flipped;
    }
  return {outward, flipped};
}

std::vector<Facet> sorted_facets(const TetMesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    auto [a, b, c, d] = mesh.tets[t];
    if (is_inverted(mesh.corners(t))) std::swap(c, d);
    for (const Triangle& outward : {Triangle{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}})
      facets.push_back(sorted_facet(outward));
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

}  // namespace

std::vector<Triangle> boundary_facets(const TetMesh& mesh) {
  const std::vector<Facet> facets = sorted_facets(mesh);
  std::vector<Triangle> boundary;
  for (auto f = facets.begin(); f != facets.end();) {
    const auto next = std::find_if(f, facets.end(), [&](const Facet& g) { return !(g == *f); });
    if (next - f == 1) boundary.push_back(f->outward());
    f = next;
  }
  return boundary;
}

}  // namespace unsliver::io
