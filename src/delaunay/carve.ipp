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

/// About every other neighbour is in conflict, and no branch predictor can tell which. So all are asked
/// before any answer is looked at, and the answers are stored, not branched upon.
template <class Geometry>
void BasicTriangulation<Geometry>::doom_neighbours(const TetRecord& tet, const Point& p,
                                                   typename Space::Shift frame) {
  TetId asked[4];
  int slots[4];
  bool doomed[4];
  typename Space::Shift shifts[4];
  int count = 0;
  for (int slot = 0; slot < 4; ++slot) {
    const TetId neighbour = tet_of(tet.n[slot]);
    std::uint8_t& mark = store_.mark(neighbour);
    asked[count] = neighbour;
    slots[count] = slot;
    count += mark == kUntested;
    if (mark == kUntested) mark = kSpared;  // asked once, though it may share two facets
  }
  for (int i = 0; i < count; ++i) {
    shifts[i] = space_.across(tet, slots[i], store_[asked[i]]);
    doomed[i] = in_conflict(asked[i], space_.seen_from(p, shifts[i]));
  }
  for (int i = 0; i < count; ++i) {
    store_.mark(asked[i]) = doomed[i] ? kDoomed : kSpared;
    cavity_.push_back_if(doomed[i], asked[i]);
    frames_.push_back_if(doomed[i], space_.sum(frame, shifts[i]));
    spared_.push_back_if(!doomed[i], asked[i]);
    for (const Facet beyond : store_[asked[i]].n) store_.prefetch(tet_of(beyond));
  }
}

/// Three corners of a neighbour are those of the tetrahedron.
template <class Geometry>
void BasicTriangulation<Geometry>::prefetch_apexes(const TetRecord& tet) const {
  for (const Facet facet : tet.n)
    __builtin_prefetch(vertices_.begin() + vertex_of(store_[tet_of(facet)].v[slot_of(facet)]));
}

template <class Geometry>
void BasicTriangulation<Geometry>::add_boundary_facets(const TetRecord& tet, typename Space::Shift frame) {
  for (int i = 0; i < 4; ++i) {
    const int* c = kFacetCorners[i];
    BoundaryFacet facet{{tet.v[c[0]], tet.v[c[1]], tet.v[c[2]]}, tet.n[i], frame};
    while (facet.v[0] == kInfinite || facet.v[1] == kInfinite)
      std::rotate(facet.v, facet.v + 1, facet.v + 3);  // keeps the orientation, puts infinity last
    boundary_.push_back_if(store_.mark(tet_of(tet.n[i])) == kSpared, facet);
  }
}

template <class Geometry>
void BasicTriangulation<Geometry>::carve(const Point& p, TetId in_conflict_with_p) {
  cavity_.clear();
  frames_.clear();
  boundary_.clear();
  spared_.clear();
  cavity_.push_back(in_conflict_with_p);
  frames_.push_back({});
  store_.mark(in_conflict_with_p) = kDoomed;
  for (std::size_t next = 0; next < cavity_.size(); ++next) {
    const TetRecord& tet = store_[cavity_[next]];
    if (next + 1 < cavity_.size()) prefetch_apexes(store_[cavity_[next + 1]]);
    const typename Space::Shift frame = frames_[next];
    doom_neighbours(tet, space_.seen_from(p, frame), frame);
    add_boundary_facets(tet, frame);
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
