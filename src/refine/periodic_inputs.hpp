/// \file
/// The input vertices of Figure 8 on a torus: each stands for all of its copies.
#pragma once

#include "delaunay/space.hpp"
#include "refine/inputs.hpp"

namespace unsliver::refine {

/// As Inputs, which it asks once for each period that a region reaches into.
class PeriodicInputs {
 public:
  /// m >= 0 distinct places at home. Labels are no coarser than `coarsest`, the coarsest lattice that the
  /// periods leave unchanged.
  PeriodicInputs(Inputs inputs, const Vec3& period, lattice::Level coarsest)
      : inputs_(std::move(inputs)), period_(period), coarsest_(coarsest) {}

  bool empty() const { return inputs_.empty(); }
  const std::vector<Vec3>& places() const { return inputs_.places(); }
  const lattice::InputSites& sites() const { return inputs_.sites(); }

  std::optional<Vec3> in_region(const Vec3& w, lattice::Level label) const {
    std::optional<Vec3> first;
    visit_shifts(w, Inputs::half_side(label), [&](const Vec3& shift) {
      const auto found = inputs_.in_region(w - shift, label);
      if (found && (!first || lex_less(*found + shift, *first))) first = *found + shift;
      return false;
    });
    return first;
  }
  bool region_is_empty(const Vec3& w, lattice::Level label) const {
    return empty() || !visit_shifts(w, Inputs::half_side(label), [&](const Vec3& shift) {
             return !inputs_.region_is_empty(w - shift, label);
           });
  }
  static bool no_region_is_empty(lattice::Level label, double distance) {
    return Inputs::no_region_is_empty(label, distance);
  }
  lattice::Level coarsest_label(const Vec3& w, lattice::Level level) const {
    const lattice::Level canonical = std::min(lattice::canonical_level(w), coarsest_);
    if (empty()) return canonical;
    while (level < canonical && region_is_empty(w, level + 1)) ++level;
    return level;
  }
  /// The copies of one vertex count each.
  bool lfs_at_most(const Vec3& w, double bound) const {
    int found = 0;
    return !empty() && visit_shifts(w, bound, [&](const Vec3& shift) {
      found += inputs_.count_within(w - shift, bound);
      return found >= 2;
    });
  }

 private:
  /// Calls visit(T) for the vectors T, in periods, for which [0, period) + T meets the cube, until it returns
  /// true; of large cubes for those next to the middle alone. Returns whether it did.
  template <class Visit>
  bool visit_shifts(const Vec3& center, double half, const Visit& visit) const {
    Vec3 first, last;
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = std::floor(center[axis] / period_[axis]);
      first[axis] = std::max(middle - 1, std::floor((center[axis] - half) / period_[axis]));
      last[axis] = std::min(middle + 1, std::floor((center[axis] + half) / period_[axis]));
    }
    for (double i = first.x; i <= last.x; ++i)
      for (double j = first.y; j <= last.y; ++j)
        for (double k = first.z; k <= last.z; ++k)
          if (visit({i * period_.x, j * period_.y, k * period_.z})) return true;
    return false;
  }

  Inputs inputs_;
  Vec3 period_;
  lattice::Level coarsest_;
};

}  // namespace unsliver::refine
