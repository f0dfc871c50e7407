/// \file
/// The map between the caller's coordinates and the integer world (docs: ALGORITHM 1).
///
/// x = origin + unit * q, unit = m * 2^e with 64 <= m < 128, origin an integer multiple of unit. For |q| <
/// 2^48 that are multiples of the finest usable lattice, x is an exact double, so a lattice mesh is exact in
/// caller's coordinates too.
#pragma once

#include "lattice/level.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::lattice {

class World {
 public:
  /// Chooses a frame for a domain box so that the box's longest side spans between 2^44 and 2^45 units and
  /// the box is centred at q = 0 (to the nearest unit... multiple of a coarse lattice step), and so that the
  /// covering radius of some BCC level is as close as possible to, and not above, `fit_radius` (in the
  /// caller's units; <= 0: nothing to fit). With a large offset the finest usable level rises so that every
  /// lattice point used is an exact double. \throws Error kLimit when fewer than 2^20 distinguishable steps
  /// are left across the box, or sizes overflow.
  static World fit(const Box3& box, double fit_radius);
  explicit World(const Frame& frame);

  const Frame& frame() const { return frame_; }
  double unit() const { return frame_.unit; }
  /// The finest level whose points are all exact doubles in caller's coordinates (kMinLevel where the offset
  /// is small).
  Level finest_level() const { return finest_level_; }

  /// Rounded to the nearest world point.
  Vec3 to_world(const Vec3& x) const;
  /// Not rounded: for real points such as circumcentres.
  Vec3 to_world_real(const Vec3& x) const;
  /// Exact for lattice points of finest_level() or coarser with |q| < 2^48.
  Vec3 to_caller(const Vec3& q) const;

 private:
  Frame frame_;
  Level finest_level_ = kMinLevel;
};

}  // namespace unsliver::lattice
