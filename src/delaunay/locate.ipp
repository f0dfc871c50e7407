// Locate: a visibility walk. It ends because Delaunay tetrahedralizations, perturbed ones too, have no
// cycles.
#pragma once

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

template <class Geometry>
int BasicTriangulation<Geometry>::orient(VertexId a, VertexId b, VertexId c, const Point& p) const {
  return exact::orient3d(position(a), position(b), position(c), Geometry::position(p), counts_.orient);
}

template <class Geometry>
TetId BasicTriangulation<Geometry>::walk_to(Point& p, TetId hint) const {
  TetId t = hint != kNoTet ? hint : created_.front();
  if (store_.is_ghost(t)) t = tet_of(store_[t].n[3]);
  space_.approach(p, position(store_[t].v[0]));
  TetId from = kNoTet;
  for (;;) {
    const TetRecord& tet = store_[t];
    TetId next = kNoTet;
    int across = 0;
    for (int i = 0; i < 4 && next == kNoTet; ++i) {
      const TetId neighbour = tet_of(tet.n[i]);
      if (neighbour == from) continue;
      const int* c = kFacetCorners[i];
      if (orient(tet.v[c[0]], tet.v[c[1]], tet.v[c[2]], p) < 0) next = neighbour, across = i;
    }
    if (next == kNoTet) return t;
    if (store_.is_ghost(next)) return next;
    p = space_.seen_from(p, space_.across(tet, across, store_[next]));
    from = t;
    t = next;
  }
}

template <class Geometry>
VertexId BasicTriangulation<Geometry>::corner_at(TetId t, const Point& p) const {
  for (VertexId v : store_[t].v)
    if (v != kInfinite && position(v) == Geometry::position(p)) return v;
  return kNoVertex;
}

}  // namespace unsliver::delaunay
