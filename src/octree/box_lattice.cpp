#include "octree/box_lattice.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

constexpr int kMantissaLimit = 128;
constexpr int kMantissaBits = 53;
constexpr int kSpanBits = 44;  ///< the longest side spans [2^44, 2^45) units
/// How far, of each side, a box that is proposed may be off: the less, the better, but some need more.
constexpr std::array kNearby = {1e-3, 1e-2};
/// Beyond so many roots the sides have no common measure that anybody meant.
constexpr double kSenseless = 0x1p40;
constexpr int kOctavesTried = 20;  ///< of root sides, below the shortest side
constexpr double kCornerSteps =
    0x1p10;  ///< lower corners that are proposed are multiples of root side / this

/// A positive double as odd * 2^exponent.
struct Dyadic {
  explicit Dyadic(double value) {
    odd = std::int64_t(std::ldexp(std::frexp(value, &exponent), kMantissaBits));
    exponent -= kMantissaBits;
    const int zeros = std::countr_zero(std::uint64_t(odd));
    odd >>= zeros;
    exponent += zeros;
  }
  std::int64_t odd;
  int exponent;
};

/// hi - lo, if it is a double.
std::optional<double> exact_side(double lo, double hi) {
  const double side = hi - lo, part = side - hi;
  const double lost = (hi - (side - part)) - (lo + part);
  return lost == 0 ? std::optional(side) : std::nullopt;
}

/// The largest d' 2^e that divide all sides: e, and the odd number that every d' divides.
struct CommonMeasure {
  std::int64_t odd = 0;
  int exponent = std::numeric_limits<int>::max();
};

std::optional<CommonMeasure> common_measure(const Box3& box) {
  CommonMeasure common;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> side = exact_side(box.lo[axis], box.hi[axis]);
    if (!side) return std::nullopt;
    const Dyadic parts(*side);
    common.odd = std::gcd(common.odd, parts.odd);
    common.exponent = std::min(common.exponent, parts.exponent);
  }
  return common;
}

/// How many roots lie along each axis. Requires a root side that divides the box's.
Vec3 counts_of(const Box3& box, double root_side) {
  const Vec3 size = box.size();
  return {size.x / root_side, size.y / root_side, size.z / root_side};
}

double root_count(const Vec3& counts) { return counts.x * counts.y * counts.z; }

/// None where the lower corner is off the grid or leaves lattice points inexact.
std::optional<lattice::World> world_at(const Vec3& corner, double unit) {
  try {
    return lattice::World({unit, corner});
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<BoxLattice> stacked(const Box3& box, double root_side) {
  const Vec3 counts = counts_of(box, root_side);
  const int exponent = kSpanBits - std::ilogb(std::max({counts.x, counts.y, counts.z}));
  const std::optional<lattice::World> world = world_at(box.lo, std::ldexp(root_side, -exponent));
  if (!world || exponent < 1) return std::nullopt;
  return BoxLattice{*world, {exponent, {0, 0, 0}, {int(counts.x), int(counts.y), int(counts.z)}}};
}

/// The lattices of at most kMostRoots, and the fewest roots of all that fit.
struct Found {
  std::vector<BoxLattice> lattices;
  double fewest_roots = std::numeric_limits<double>::infinity();
};

Found find_lattices(const Box3& box) {
  Found found;
  const std::optional<CommonMeasure> common = common_measure(box);
  if (!common) return found;
  for (int d = kMantissaLimit - 1; d > 0; d -= 2) {
    if (common->odd % d != 0) continue;
    const double root_side = std::ldexp(double(d), common->exponent);
    const double roots = root_count(counts_of(box, root_side));
    if (roots <= kMostRoots) {
      if (const auto lattice = stacked(box, root_side)) found.lattices.push_back(*lattice);
    }
    found.fewest_roots = std::min(found.fewest_roots, roots);
  }
  return found;
}

/// Sides rounded to multiples of the root side, the corner to a fine grid of it.
Box3 snapped(const Box3& box, double root_side) {
  const double step = root_side / kCornerSteps;
  const Vec3 size = box.size();
  Box3 near;
  for (int axis = 0; axis < 3; ++axis) {
    near.lo[axis] = step * std::nearbyint(box.lo[axis] / step) + 0.0;  // no -0
    near.hi[axis] = near.lo[axis] + root_side * std::max(1.0, std::nearbyint(size[axis] / root_side));
  }
  return near;
}

/// The largest deviation of a side, as a share of it.
double deviation(const Box3& a, const Box3& from) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max(largest, std::abs(a.size()[axis] / from.size()[axis] - 1));
  return largest;
}

/// That of the largest roots, of the sizes that a world can have.
std::optional<Box3> nearest_box(const Box3& box, double tolerance) {
  const Vec3 size = box.size();
  const int top = std::ilogb(std::min({size.x, size.y, size.z})) - 5;  // 2^top * 64 > the shortest side
  for (int e = top; e > top - kOctavesTried; --e)
    for (int m = kMantissaLimit - 1; m >= kMantissaLimit / 2; --m) {
      const double root_side = std::ldexp(double(m), e);
      if (root_count(counts_of(box, root_side)) > kMostRoots) return std::nullopt;
      const Box3 near = snapped(box, root_side);
      if (deviation(near, box) <= tolerance && !find_lattices(near).lattices.empty()) return near;
    }
  return std::nullopt;
}

std::optional<Box3> nearest_box(const Box3& box) {
  std::optional<Box3> near;
  for (const double tolerance : kNearby)
    if (!near) near = nearest_box(box, tolerance);
  return near;
}

std::string corners_text(const Box3& box) {
  return fmt::format("{} {} {} {} {} {}", box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z);
}

std::string remedy(const Box3& box, const std::optional<Box3>& near) {
  if (!near) return "No box near it will do: it is too thin, or too far from the origin";
  return fmt::format("One that will do, its sides off by at most {:.2g} %, is \"{}\"",
                     100 * deviation(*near, box), corners_text(*near));
}

[[noreturn]] void refuse(const Box3& box, double fewest_roots) {
  const std::optional<Box3> near = nearest_box(box);
  const bool too_many = kMostRoots < fewest_roots && fewest_roots < kSenseless;
  const std::string reason =
      too_many ? fmt::format(
                     "it takes {:.0f} equal cubes to fill the box \"{}\" exactly, and {:.0f} are the limit",
                     fewest_roots, corners_text(box), kMostRoots)
               : fmt::format(
                     "no equal cubes fill the box \"{}\" exactly: its sides have to be whole multiples of "
                     "one length m * 2^e, m a whole number below {}, its corners multiples of some "
                     "m * 2^e too (0.75 is one, 0.1 is not)",
                     corners_text(box), kMantissaLimit);
  Error error(too_many ? ErrorCode::kLimit : ErrorCode::kUnsupported,
              fmt::format("{}. {}", reason, remedy(box, near)));
  if (near) error.places = {near->lo, near->hi};
  throw error;
}

}  // namespace

std::vector<BoxLattice> lattices_of(const Box3& box) {
  Found found = find_lattices(box);
  if (found.lattices.empty()) refuse(box, found.fewest_roots);
  return std::move(found.lattices);
}

}  // namespace unsliver::octree
