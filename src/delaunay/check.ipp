// The invariants of the structure, checked one by one for tests.
#pragma once

#include <stdexcept>
#include <string>

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

template <class Geometry>
void BasicTriangulation<Geometry>::check_facet(TetId t, int slot) const {
  const auto fail = [&](const char* what) {
    throw std::logic_error(std::string(what) + " at tetrahedron " + std::to_string(t) + ", facet " +
                           std::to_string(slot));
  };
  const TetRecord& tet = store_[t];
  const TetId u = tet_of(tet.n[slot]);
  if (!store_.alive(u)) fail("a neighbour is not alive");
  const TetRecord& other = store_[u];
  const int back = slot_of(tet.n[slot]);
  if (other.n[back] != facet_of(t, slot)) fail("neighbours do not know each other");
  std::array<VertexId, 3> mine, theirs;
  for (int j = 0; j < 3; ++j) {
    mine[j] = vertex_of(tet.v[kFacetCorners[slot][j]]);
    theirs[j] = vertex_of(other.v[kFacetCorners[back][j]]);
  }
  std::sort(mine.begin(), mine.end());
  std::sort(theirs.begin(), theirs.end());
  if (mine != theirs) fail("neighbours share no facet");
  const auto shift = space_.across(other, back, tet);
  for (const VertexId v : other.v)
    for (const VertexId w : tet.v)
      if (v != kInfinite && vertex_of(v) == vertex_of(w) &&
          Geometry::position(space_.seen_from(point(v), shift)) != position(w))
        fail("neighbours do not agree on the place of a corner");
  if (const VertexId apex = other.v[back];
      apex != kInfinite && in_conflict(t, space_.seen_from(point(apex), shift)))
    fail("not locally Delaunay");
}

template <class Geometry>
void BasicTriangulation<Geometry>::check() const {
  for (TetId t = 0; t < store_.slot_count(); ++t) {
    if (!store_.alive(t)) continue;
    const TetRecord& tet = store_[t];
    if (!store_.is_ghost(t) && orient(tet.v[0], tet.v[1], tet.v[2], point(tet.v[3])) <= 0)
      throw std::logic_error("tetrahedron " + std::to_string(t) + " is not positively oriented");
    for (int i = 0; i < 4; ++i) check_facet(t, i);
  }
}

}  // namespace unsliver::delaunay
