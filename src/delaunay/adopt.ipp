// Adopt: a tetrahedralization from outside, of which only neighbours are missing. On a torus a facet is told
// by its vertices.
#pragma once

#include <algorithm>
#include <array>

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

namespace detail {

/// A facet of some tetrahedron, told by its vertices.
struct NamedFacet {
  std::array<VertexId, 3> vertices;
  Facet facet;
  bool operator<(const NamedFacet& other) const { return vertices < other.vertices; }
};

}  // namespace detail

template <class Geometry>
void BasicTriangulation<Geometry>::adopt(std::span<const Point> points,
                                         std::span<const std::array<VertexId, 4>> tets) {
  for (const Point& p : points) add_vertex(p);
  std::vector<detail::NamedFacet> facets;
  facets.reserve(4 * tets.size());
  for (const auto& v : tets) {
    const TetId t = store_.allocate();
    store_[t] = {{v[0], v[1], v[2], v[3]}, {}};
    for (int slot = 0; slot < 4; ++slot) {
      const int* c = kFacetCorners[slot];
      detail::NamedFacet facet{
          {vertex_of(v[std::size_t(c[0])]), vertex_of(v[std::size_t(c[1])]), vertex_of(v[std::size_t(c[2])])},
          facet_of(t, slot)};
      std::sort(facet.vertices.begin(), facet.vertices.end());
      facets.push_back(facet);
    }
  }
  std::sort(facets.begin(), facets.end());
  for (std::size_t i = 0; i + 1 < facets.size(); i += 2) store_.glue(facets[i].facet, facets[i + 1].facet);
  created_.assign(1, 0);
  dimension_ = 3;
}

}  // namespace unsliver::delaunay
