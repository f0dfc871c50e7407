/// \file
/// The Delaunay tetrahedralization of a few points, facet by facet.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/predicates.hpp"

namespace unsliver::octree {

/// At most kMaxPoints distinct integer points that do not all lie in a plane. The result is that of
/// delaunay::Triangulation: ties are broken by the same symbolic perturbation. O(n) a facet.
class GiftWrapping {
 public:
  static constexpr std::size_t kMaxPoints = 64;
  using Corners = std::array<std::uint8_t, 4>;  ///< numbers of points, positively oriented

  explicit GiftWrapping(std::span<const Vec3> points);

  const std::vector<Corners>& tets() const { return tets_; }

 private:
  struct Facet {
    std::uint8_t a, b, c;  ///< the side that is not wrapped yet is the positive one
  };

  Corners first_tet();
  bool is_empty(const Corners& t);
  int apex(const Facet& facet);
  bool in_conflict(const Facet& facet, int d, int e);
  void add(const Corners& t);
  void toggle(const Facet& facet);

  std::span<const Vec3> points_;
  std::vector<Corners> tets_;
  std::vector<Facet> waiting_;
  std::bitset<kMaxPoints * kMaxPoints * kMaxPoints> open_;  ///< facets with one tetrahedron
  exact::StageCounts counts_;
};

}  // namespace unsliver::octree
