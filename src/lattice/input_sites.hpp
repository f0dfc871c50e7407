/// \file
/// The places that the caller's points ask for: duplicates merged, points too close together refused.
///
/// How close is too close: a refinement vertex v of SC_k has lfs(v) <= 108.72 * 2^k (Labelle 5.2), and where
/// two inputs are d or more apart everywhere, lfs(v) >= d/2; so 2^k >= d / 217.44. Where d > 108.72 * 2^j,
/// this exceeds 2^(j-1), and no lattice finer than SC_j is ever used. kStepsBetween adds to the 108.72 what
/// rounding to the world may take away.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lattice/world.hpp"

namespace unsliver::lattice {

/// Distinct points are to be at least this share of the extent apart: at least 175 units of a fitted world.
inline constexpr double kLeastSeparation = 1e-11;
/// ... and so many steps of the finest usable lattice.
inline constexpr double kStepsBetween = 112;

/// n points of the caller on m <= n sites, which are numbered in the order of their first points.
struct InputSites {
  std::vector<VertexId> first_point;  ///< m: the first of the caller's points on each site
  std::vector<VertexId> site_of;      ///< n: the site of each point
  /// Least distance between two sites, in the caller's units; infinity when there is one at most.
  double closest = std::numeric_limits<double>::infinity();

  std::size_t duplicate_count() const { return site_of.size() - first_point.size(); }
  /// For World::fit: the coarsest finest lattice that these sites can do with.
  double max_step() const { return closest / kStepsBetween; }
  /// The points of each site that has several, in ascending order, sites likewise.
  std::vector<std::vector<VertexId>> merged_groups() const;
  /// What was merged, as a sentence for the user; empty when nothing was.
  std::string note() const;
};

/// Points that are equal as numbers (so -0 and 0) share a site. O(n log n).
/// \param extent longest side of the domain's box, in the caller's units; >= 0
/// \throws Error kBadInput when a coordinate is not finite, or when two different points are closer than
/// kLeastSeparation * extent: it names the closest two, their places and their distance; kLimit when there
/// are too many points to number.
InputSites find_sites(std::span<const Vec3> points, double extent);

/// The world points of the sites, each nearest to the caller's; they are distinct.
/// \throws Error kBadInput when one lies outside the world, |q| < 2^48, or the world is too coarse for them:
/// neither happens where the world was fitted to a box that holds the points, the extent being its own.
std::vector<Vec3> to_world(const InputSites& sites, std::span<const Vec3> points, const World& world);

}  // namespace unsliver::lattice
