// Fill: the star of the new vertex over the cavity's boundary. New tetrahedra take the slots of the old ones.
#pragma once

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

template <class Geometry>
VertexId BasicTriangulation<Geometry>::fill(const Point& p) {
  const VertexId v = add_vertex(space_.home_of(p));
  fill_with(v, space_.shift_from_home(p));
  return v;
}

template <class Geometry>
void BasicTriangulation<Geometry>::fill_with(VertexId v, typename Space::Shift from_home) {
  clear_spared_marks();
  number_boundary_vertices();
  make_star(v, from_home);
  link_star();
}

/// Numbers the boundary's vertices 0, 1, ... in local_. A vertex is new to this cavity when its number is
/// below the cavity's base: nothing needs to be cleared.
template <class Geometry>
void BasicTriangulation<Geometry>::number_boundary_vertices() {
  const std::uint64_t base = next_number_;
  local_.resize(boundary_.size());
  for (std::size_t i = 0; i < boundary_.size(); ++i)
    for (int j = 0; j < 3; ++j) {
      std::uint64_t& number = vertices_[vertex_of(boundary_[i].v[j])].number;
      if (number < base) number = next_number_++;
      local_[i].v[j] = static_cast<std::uint32_t>(number - base);
    }
  edges_.start(static_cast<std::uint32_t>(next_number_ - base));
}

/// The slots of a star tetrahedron that lie opposite the facet's corners. An infinite corner must be
/// corner 3.
inline constexpr int kFiniteSlots[3] = {0, 1, 2};
inline constexpr int kGhostSlots[3] = {1, 0, 3};

template <class Geometry>
void BasicTriangulation<Geometry>::make_star(VertexId v, typename Space::Shift from_home) {
  created_.clear();
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    const TetId t = i < cavity_.size() ? cavity_[i] : store_.allocate();
    store_.mark(t) = kUntested;
    created_.push_back(t);
    const BoundaryFacet& facet = boundary_[i];
    const bool ghost = facet.v[2] == kInfinite;
    TetRecord& tet = store_[t];
    if (ghost)
      tet = {{facet.v[1], facet.v[0], v, kInfinite}, {}};
    else
      tet = {{facet.v[0], facet.v[1], facet.v[2], v}, {}};
    space_.place_apex(tet.v, facet.frame, from_home);
    store_.glue(facet_of(t, ghost ? 2 : 3), facet.outer);
    const int* slots = ghost ? kGhostSlots : kFiniteSlots;
    const auto& n = local_[i].v;
    edges_.add(n[1], n[2], facet_of(t, slots[0]));
    edges_.add(n[2], n[0], facet_of(t, slots[1]));
    edges_.add(n[0], n[1], facet_of(t, slots[2]));
  }
  for (std::size_t i = boundary_.size(); i < cavity_.size(); ++i) {
    store_.mark(cavity_[i]) = kUntested;
    store_.release(cavity_[i]);
  }
}

template <class Geometry>
void BasicTriangulation<Geometry>::link_star() {
  edges_.finish();
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    TetRecord& tet = store_[created_[i]];
    const int* slots = boundary_[i].v[2] == kInfinite ? kGhostSlots : kFiniteSlots;
    const auto& n = local_[i].v;
    tet.n[slots[0]] = edges_.find(n[2], n[1]);
    tet.n[slots[1]] = edges_.find(n[0], n[2]);
    tet.n[slots[2]] = edges_.find(n[1], n[0]);
  }
}

}  // namespace unsliver::delaunay
