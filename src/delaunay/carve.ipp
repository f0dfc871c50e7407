// Carve: the conflict region of a point is connected, so a flood from one member finds it and its boundary.
#pragma once

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

/// A ghost is in conflict with every point strictly beyond its facet. In the facet's plane the ghost's open
/// disk is the section of its finite neighbour's ball, perturbation included (the apex has no influence on
/// the tie of four coplanar points), so the neighbour decides.
template <class Geometry>
bool BasicTriangulation<Geometry>::in_conflict(TetId t, const Point& p) const {
  const TetRecord* tet = &store_[t];
  if (tet->v[3] == kInfinite) {
    const int side = orient(tet->v[0], tet->v[1], tet->v[2], p);
    if (side != 0) return side > 0;
    tet = &store_[tet_of(tet->n[3])];
  }
  return Geometry::in_conflict(point(tet->v[0]), point(tet->v[1]), point(tet->v[2]), point(tet->v[3]), p,
                               counts_);
}

template <class Geometry>
void BasicTriangulation<Geometry>::add_boundary_facet(const TetRecord& tet, int slot) {
  const int* c = kFacetCorners[slot];
  BoundaryFacet facet{{tet.v[c[0]], tet.v[c[1]], tet.v[c[2]]}, tet.n[slot]};
  while (facet.v[0] == kInfinite || facet.v[1] == kInfinite)
    std::rotate(facet.v, facet.v + 1, facet.v + 3);  // keeps the orientation, puts infinity last
  boundary_.push_back(facet);
}

/// Flattened: the conflict test is most of the work, and a call costs a tenth of it.
template <class Geometry>
[[gnu::flatten]] void BasicTriangulation<Geometry>::carve(const Point& p, TetId in_conflict_with_p) {
  cavity_.assign(1, in_conflict_with_p);
  boundary_.clear();
  spared_.clear();
  store_.mark(in_conflict_with_p) = kDoomed;
  for (std::size_t next = 0; next < cavity_.size(); ++next) {
    const TetRecord& tet = store_[cavity_[next]];
    for (int i = 0; i < 4; ++i) {
      const TetId neighbour = tet_of(tet.n[i]);
      std::uint8_t& mark = store_.mark(neighbour);
      if (mark == kUntested) {
        if (in_conflict(neighbour, p)) {
          mark = kDoomed;
          cavity_.push_back(neighbour);
          for (const Facet beyond : store_[neighbour].n) store_.prefetch(tet_of(beyond));
        } else {
          mark = kSpared;
          spared_.push_back(neighbour);
        }
      }
      if (mark == kSpared) add_boundary_facet(tet, i);
    }
  }
}

template <class Geometry>
void BasicTriangulation<Geometry>::clear_spared_marks() {
  for (TetId t : spared_) store_.mark(t) = kUntested;
}

template <class Geometry>
void BasicTriangulation<Geometry>::abandon() {
  clear_spared_marks();
  for (TetId t : cavity_) store_.mark(t) = kUntested;
}

}  // namespace unsliver::delaunay
