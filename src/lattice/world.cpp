#include "lattice/world.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "unsliver/error.hpp"

namespace unsliver::lattice {
namespace {

constexpr double kReach = 0x1p48;       ///< |q| < kReach
constexpr double kOriginStep = 0x1p40;  ///< fitted origins are multiples of this many units
constexpr int kSpanBits = 44;           ///< the box spans [2^44, 2^45) units
constexpr int kMantissaBits = 7;        ///< m < 2^7

double max_norm(const Vec3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }

Vec3 rounded(const Vec3& a) {
  return {std::nearbyint(a.x) + 0.0, std::nearbyint(a.y) + 0.0, std::nearbyint(a.z) + 0.0};  // no -0
}

/// The integer nearest to (x - origin) / unit, as World::to_world promises.
///
/// The quotient q is rounded twice, so it errs by about 2^-52 |q| at most, a sixteenth; only near a
/// half-integer h can that matter. There d + lost = x - origin (Knuth's two-sum), and d - unit h is a double:
/// below |d| and unit / 4 in magnitude, and a multiple of the last place of d or of 2^(e - 1).
double nearest_step(double x, double origin, double unit) {
  const double d = x - origin;
  const double q = d / unit;
  const double nearest = std::nearbyint(q);
  constexpr double kSure = 0.5 - 0x1p-3;
  if (!(std::abs(q) <= kReach + 1) || std::abs(q - nearest) < kSure) return nearest;
  const double part = d - x;
  const double lost = (x - (d - part)) - (origin + part);
  const double h = std::floor(q) + 0.5;
  const double beyond = std::fma(-unit, h, d) + lost;
  if (beyond == 0) return std::nearbyint(h);
  return beyond < 0 ? h - 0.5 : h + 0.5;
}

Vec3 divide(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

/// A positive number as m * 2^e, 64 <= m < 128 (m an integer for units, any real for sizes).
struct Scaled {
  explicit Scaled(double value) {
    m = std::ldexp(std::frexp(value, &e), kMantissaBits);
    e -= kMantissaBits;
  }
  double m;
  int e;
};

double odd_part(double m) {
  while (std::fmod(m, 2) == 0) m /= 2;
  return m;
}

/// The smallest z >= 0 with (|shift| + 2^48) m' <= 2^(53 + z), m' the odd part of m.
int exact_exponent(double m, const Vec3& shift) {
  int z = 0;
  const double fraction = std::frexp((0x1p-53 * max_norm(shift) + 0x1p-53 * kReach) * odd_part(m), &z);
  return std::max(0, fraction == 0.5 ? z - 1 : z);
}

/// The same for a frame of any origin; nothing when the frame has not the form of the header.
std::optional<int> exact_exponent(const Frame& frame) {
  const double reach = max_norm(frame.origin) + kReach * frame.unit;
  if (!(frame.unit > 0) || !std::isnormal(frame.unit) || !is_finite(frame.origin) || !std::isfinite(reach)) {
    return std::nullopt;
  }
  const double m = Scaled(frame.unit).m;
  const Vec3 shift = divide(frame.origin, frame.unit);
  if (m != std::floor(m) || shift != rounded(shift) || frame.unit * shift != frame.origin) {
    return std::nullopt;
  }
  const int z = exact_exponent(m, shift);
  const Vec3 multiple = divide(shift, std::ldexp(1.0, z));
  const bool usable = 2 * z + 1 <= kMaxLevel && multiple == rounded(multiple);
  return usable ? std::optional(z) : std::nullopt;
}

/// The largest m * 2^p, m an integer in [64, 128), with covering_radius(BCC_0) m 2^p <= radius.
Scaled largest_fitting(double radius) {
  Scaled best(radius / kQuarterSqrt5);
  best.m = std::floor(best.m) + 1;  // the quotient was rounded, either way
  while (kQuarterSqrt5 * best.m > std::ldexp(radius, -best.e)) best.m -= 1;
  if (best.m < 64) best.m = 127, best.e -= 1;
  return best;
}

/// m with its leading `bits` bits only.
double leading_bits(double m, int bits) {
  const double step = std::ldexp(1.0, kMantissaBits - bits);
  return step * std::floor(m / step);
}

/// A frame for the box, and what it leaves.
struct Candidate {
  Frame frame;
  int unit_exponent = 0;  ///< unit = m * 2^unit_exponent
  int finest_bcc = 0;     ///< k of the finest usable BCC_k
  double step = 0;        ///< of the finest usable lattice, in the caller's units
  double steps = 0;       ///< so many across the box
};

Candidate frame_box(const Box3& box, double m) {
  Candidate c;
  c.unit_exponent = std::ilogb(box.longest_side() / m) - kSpanBits;
  c.frame.unit = std::ldexp(m, c.unit_exponent);
  const double step = c.frame.unit * kOriginStep;
  const Vec3 steps_to_center = rounded(divide(box.center(), step));
  c.frame.origin = step * steps_to_center;
  const int z = exact_exponent(m, kOriginStep * steps_to_center);
  c.finest_bcc = z + 1;
  c.step = std::ldexp(c.frame.unit, z);
  c.steps = box.longest_side() / c.step;
  return c;
}

double farthest_coordinate(const Box3& box) { return std::max(max_norm(box.lo), max_norm(box.hi)); }

[[noreturn]] void refuse(ErrorCode code, const Box3& box, std::string message) {
  Error error(code, std::move(message));
  error.places = {box.lo, box.hi};
  throw error;
}

void require_in_range(const Box3& box) {
  if (!is_finite(box.lo) || !is_finite(box.hi)) {
    refuse(ErrorCode::kBadInput, box,
           "The domain's box is empty or not finite: give it points, all of them finite.");
  }
  if (box.empty() || box.longest_side() == 0) {
    refuse(ErrorCode::kBadInput, box,
           fmt::format("The domain's box from ({}, {}, {}) to ({}, {}, {}) holds no volume to mesh.",
                       box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z));
  }
  if (box.longest_side() < World::kMinExtent || farthest_coordinate(box) > World::kMaxCoordinate) {
    refuse(ErrorCode::kLimit, box,
           fmt::format(
               "The domain's box is {:.6g} wide and its coordinates reach {:.6g}: the width has to be at "
               "least {} and coordinates at most {}. Choose another unit of length.",
               box.longest_side(), farthest_coordinate(box), World::kMinExtent, World::kMaxCoordinate));
  }
}

void require_steps(const Box3& box, double steps) {
  if (steps >= World::kMinSteps) return;
  refuse(ErrorCode::kLimit, box,
         fmt::format("The domain's box is {:.6g} wide but its coordinates reach {:.6g}: doubles leave {:.6g} "
                     "lattice steps across it, and {:.6g} are needed. Move the domain closer to the origin "
                     "(subtract its centre from all coordinates).",
                     box.longest_side(), farthest_coordinate(box), steps, World::kMinSteps));
}

[[noreturn]] void refuse_size(const Box3& box, double fit_radius, double finest_radius) {
  refuse(
      ErrorCode::kLimit, box,
      fmt::format("The size {:.6g} is too small for a domain {:.6g} wide whose coordinates reach {:.6g}: the "
                  "finest lattice of exact doubles there has empty balls of radius {:.6g}. Ask for a larger "
                  "size, or move a domain that is far from the origin closer to it.",
                  fit_radius, box.longest_side(), farthest_coordinate(box), finest_radius));
}

[[noreturn]] void refuse_step(const Box3& box, double max_step, double step) {
  refuse(
      ErrorCode::kLimit, box,
      fmt::format("Some points to be meshed are so close together that a lattice of step {:.6g} is needed, "
                  "but in a domain {:.6g} wide whose coordinates reach {:.6g}, the finest lattice of exact "
                  "doubles has step {:.6g}. Merge points that are close, or move a domain that is far from "
                  "the origin closer to it.",
                  max_step, box.longest_side(), farthest_coordinate(box), step));
}

}  // namespace

World World::fit(const Box3& box, double fit_radius, double max_step) {
  require_in_range(box);
  require_steps(box, 0x1p53 * (box.longest_side() / farthest_coordinate(box)));
  const bool fitting = fit_radius > 0 && fit_radius <= 4 * box.longest_side();
  const Scaled wanted = fitting ? largest_fitting(fit_radius) : Scaled(64);
  Candidate c;
  for (int bits = kMantissaBits; bits > 0; --bits) {
    c = frame_box(box, leading_bits(wanted.m, bits));
    const int fitted_bcc = fitting ? wanted.e - c.unit_exponent : c.finest_bcc;
    if (c.steps >= kMinSteps && fitted_bcc >= c.finest_bcc && c.step <= max_step) return World(c.frame);
  }
  require_steps(box, c.steps);
  if (c.step > max_step) refuse_step(box, max_step, c.step);
  refuse_size(box, fit_radius, covering_radius(2 * c.finest_bcc) * c.frame.unit);
}

World::World(const Frame& frame) : frame_(frame), shift_(divide(frame.origin, frame.unit)) {
  const std::optional<int> z = exact_exponent(frame);
  if (!z) {
    throw Error(
        ErrorCode::kBadInput,
        fmt::format("The frame with unit {} and origin ({}, {}, {}) is not one of ours: the unit has to "
                    "be m * 2^e with an integer m from 64 to 127, the origin a multiple of the unit "
                    "that leaves lattice points exact, and both have to be in the range of doubles.",
                    frame.unit, frame.origin.x, frame.origin.y, frame.origin.z));
  }
  finest_level_ = 2 * *z + 1;
}

Vec3 World::to_world(const Vec3& x) const {
  const auto coordinate = [&](int axis) {
    return nearest_step(x[axis], frame_.origin[axis], frame_.unit) + 0.0;  // no -0
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

Vec3 World::to_world_real(const Vec3& x) const { return divide(x - frame_.origin, frame_.unit); }

Vec3 World::to_caller(const Vec3& q) const { return frame_.unit * (shift_ + q); }

}  // namespace unsliver::lattice
