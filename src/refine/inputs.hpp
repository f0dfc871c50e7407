/// \file
/// The input vertices of Figure 8, and what the algorithm asks of them.
#pragma once

#include "geom/point_tree.hpp"
#include "lattice/forbidden_region.hpp"
#include "lattice/input_sites.hpp"

namespace unsliver::refine {

/// Static: all are known before the first refinement vertex. Places are world points.
class Inputs {
 public:
  /// m >= 0 distinct places. `sites` says which of the caller's points they stand for.
  Inputs(lattice::InputSites sites, std::vector<Vec3> places)
      : sites_(std::move(sites)), places_(std::move(places)), tree_(places_) {}

  bool empty() const { return places_.empty(); }
  const std::vector<Vec3>& places() const { return places_; }
  const lattice::InputSites& sites() const { return sites_; }

  /// "Is there an input vertex in the region R(w, k)?", k that of the label. The lexicographically smallest.
  std::optional<Vec3> in_region(const Vec3& w, lattice::Level label) const {
    if (empty()) return std::nullopt;
    const VertexId site = tree_.first_in_cube(w, half_side(label));
    return site == kNoVertex ? std::nullopt : std::optional(places_[site]);
  }
  bool region_is_empty(const Vec3& w, lattice::Level label) const {
    return empty() || !tree_.has_in_cube(w, half_side(label));
  }

  /// Does the region of every point no farther than `distance` from some input vertex hold that vertex?
  static bool no_region_is_empty(lattice::Level label, double distance) {
    return distance * (1 + 1e-9) <= half_side(label);
  }

  /// The coarsest label that w, of this level's lattice, can carry: its region is empty. Requires that the
  /// level's own is.
  lattice::Level coarsest_label(const Vec3& w, lattice::Level level) const {
    const lattice::Level canonical = lattice::canonical_level(w);
    if (empty()) return canonical;
    while (level < canonical && region_is_empty(w, level + 1)) ++level;
    return level;
  }

  /// lfs_i(w) <= bound? lfs_i is the distance to the second nearest input vertex (Definition 1).
  bool lfs_at_most(const Vec3& w, double bound) const { return !empty() && tree_.has_within(w, bound, 2); }
  /// How many of them, up to 2, lie within this distance of w.
  int count_within(const Vec3& w, double distance) const {
    return tree_.has_within(w, distance, 2) ? 2 : tree_.has_within(w, distance, 1) ? 1 : 0;
  }

  /// Of a label's forbidden region.
  static double half_side(lattice::Level label) {
    return lattice::half_side(lattice::region_exponent(label));
  }

 private:
  lattice::InputSites sites_;
  std::vector<Vec3> places_;
  geom::PointTree tree_;
};

}  // namespace unsliver::refine
