// Below four affinely independent points there are no tetrahedra; with the fourth the first one and its four
// ghosts.
#pragma once

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

/// Is p affinely independent of the basis (which has at most three points)?
template <class Geometry>
bool BasicTriangulation<Geometry>::extends_basis(const Point& p) const {
  const Vec3& q = Geometry::position(p);
  if (basis_.empty()) return true;
  const Vec3& a = position(basis_[0]);
  if (basis_.size() == 1) return q != a;
  const Vec3& b = position(basis_[1]);
  if (basis_.size() == 3) return exact::orient3d(a, b, position(basis_[2]), q, counts_.orient) != 0;
  // The cross product of b - a and q - a, one component a test.
  const Vec3 steps[3] = {{a.x + 1, a.y, a.z}, {a.x, a.y + 1, a.z}, {a.x, a.y, a.z + 1}};
  return std::any_of(std::begin(steps), std::end(steps),
                     [&](const Vec3& step) { return exact::orient3d(a, b, q, step, counts_.orient) != 0; });
}

template <class Geometry>
VertexId BasicTriangulation<Geometry>::insert_low_dimensional(const Point& p) {
  if (const auto found = flat_.find(Geometry::position(p)); found != flat_.end()) return found->second;
  const VertexId v = add_vertex(p);
  flat_.emplace(Geometry::position(p), v);
  if (extends_basis(p)) {
    basis_.push_back(v);
    if (++dimension_ == 3) start();
  }
  return v;
}

/// Makes the first tetrahedron of the basis, then inserts the coplanar vertices that waited.
template <class Geometry>
void BasicTriangulation<Geometry>::start() {
  if (orient(basis_[0], basis_[1], basis_[2], point(basis_[3])) < 0) std::swap(basis_[0], basis_[1]);
  const TetId inner = store_.allocate();
  for (int i = 0; i < 4; ++i) store_[inner].v[i] = basis_[i];
  TetId ghosts[4];
  for (int i = 0; i < 4; ++i) {
    ghosts[i] = store_.allocate();
    const int* c = kFacetCorners[i];
    // Corners swapped: seen from beyond the facet.
    store_[ghosts[i]] = {{basis_[c[1]], basis_[c[0]], basis_[c[2]], kInfinite}, {}};
    store_.glue(facet_of(inner, i), facet_of(ghosts[i], 3));
  }
  for (int i = 0; i < 4; ++i)
    for (int slot = 0; slot < 3; ++slot) {
      // Facet `slot` of ghost i lacks one basis corner beside corner i: that corner's ghost is behind it.
      const VertexId missing = store_[ghosts[i]].v[slot];
      const int j = static_cast<int>(std::find(basis_.begin(), basis_.end(), missing) - basis_.begin());
      const auto& w = store_[ghosts[j]].v;
      const int back = static_cast<int>(std::find(w, w + 3, basis_[i]) - w);
      store_[ghosts[i]].n[slot] = facet_of(ghosts[j], back);
    }
  created_ = {inner, ghosts[0], ghosts[1], ghosts[2], ghosts[3]};

  const auto waiting = std::exchange(flat_, std::map<Vec3, VertexId, decltype(&lex_less)>{&lex_less});
  for (const auto& [where, v] : waiting) {
    if (std::find(basis_.begin(), basis_.end(), v) != basis_.end()) continue;
    carve(point(v), locate(point(v)));
    fill_with(v);
  }
}

}  // namespace unsliver::delaunay
