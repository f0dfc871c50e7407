/// \file
/// The map between the caller's coordinates and the integer world (docs: ALGORITHM 1).
///
/// x = origin + unit * q, unit = m * 2^e with 64 <= m < 128, origin an integer multiple of unit. For |q| <
/// 2^48 that are multiples of the finest usable lattice, x is an exact double, so a lattice mesh is exact in
/// caller's coordinates too.
///
/// Why: x = (o + q) m 2^e with o = origin / unit. Where o and q are multiples of 2^z, x is an exact double
/// as soon as (|o| + 2^48) m' <= 2^(53 + z), m' being the odd part of m. The finest usable level is SC_z for
/// the smallest such z >= 0: for o = 0, z = 0 where m' < 32, else 1 or 2; every doubling of a large |o|
/// adds 1.
#pragma once

#include "lattice/level.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::lattice {

class World {
 public:
  /// Chooses a frame for a domain box.
  /// - The longest side of the box spans at least 2^44 and less than 2^45 units (to rounding).
  /// - The origin is the multiple of 2^40 units nearest to the centre of the box.
  /// - fit_radius is in the caller's units; outside (0, 4 longest sides] there is nothing to fit, and m = 64.
  ///   Else, for some usable BCC level, fit_radius * 64/65 < covering_radius(level) * unit <= fit_radius.
  ///   Where a large offset needs digits, m gives up low bits one at a time: the left bound is then as low
  ///   as fit_radius / 2.
  /// - The spacing of finest_level() is at most max_step, in the caller's units; m gives up bits for it too.
  /// \throws Error kBadInput when the box is empty, not finite or a single point; kLimit when its longest
  /// side is below kMinExtent or a coordinate beyond kMaxCoordinate, when the offset leaves fewer than
  /// kMinSteps steps of the finest usable lattice across the box, or when no usable level is as fine as
  /// fit_radius or max_step.
  static World fit(const Box3& box, double fit_radius,
                   double max_step = std::numeric_limits<double>::infinity());

  /// \throws Error kBadInput when the frame has not the form above, or exceeds the range of doubles.
  explicit World(const Frame& frame);

  /// The range of fit(): units stay normal and the world stays finite.
  static constexpr double kMinExtent = 1e-290;
  static constexpr double kMaxCoordinate = 1e300;
  /// The fewest steps of the finest usable lattice that fit() leaves across the longest side.
  static constexpr double kMinSteps = 0x1p20;

  const Frame& frame() const { return frame_; }
  double unit() const { return frame_.unit; }
  /// The finest level whose points are all exact doubles in caller's coordinates (kMinLevel where the offset
  /// is small and m a short number; an odd level).
  Level finest_level() const { return finest_level_; }

  /// The nearest world point: each coordinate is the integer nearest to (x - origin) / unit, a tie going to
  /// the even one. Decided exactly where that integer is at most 2^48 in magnitude; beyond, the result is
  /// beyond too (infinite or NaN for x that is).
  Vec3 to_world(const Vec3& x) const;
  /// Not rounded: for real points such as circumcentres.
  Vec3 to_world_real(const Vec3& x) const;
  /// Exact for lattice points of finest_level() or coarser with |q| < 2^48; rounded to nearest elsewhere.
  Vec3 to_caller(const Vec3& q) const;

 private:
  Frame frame_;
  Vec3 shift_;  ///< origin / unit, integers
  Level finest_level_ = kMinLevel;
};

}  // namespace unsliver::lattice
