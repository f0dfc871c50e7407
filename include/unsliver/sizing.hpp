/// \file
/// How fine: the sizing function s of Labelle's Definition 1, in the caller's units.
///
/// s(p) is a ball radius: in the final mesh every closed ball B(p, s(p)), p in the domain, holds a vertex.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/types.hpp"

namespace unsliver {

/// A positive function on space (it may be infinite). Const and safe to call from several threads.
class Sizing {
 public:
  virtual ~Sizing() = default;

  /// s(p) > 0. \throws Error kBadInput naming p when the underlying function gives NaN, zero or less.
  virtual double at(const Vec3& p) const = 0;

  /// A lower bound of s over the box, > 0; sound, and tight when the box is small.
  virtual double lower_bound(const Box3& box) const = 0;

  /// A constant L with |s(p) - s(q)| <= L |p - q| wherever both are finite, or infinity if none is known.
  virtual double lipschitz() const = 0;

  /// As lipschitz(), for p and q in the box; infinity if s may jump there.
  virtual double lipschitz_over(const Box3& /*box*/) const { return lipschitz(); }

  /// One line for the report, such as "constant 0.1".
  virtual std::string describe() const = 0;

  /// What a careful user must know, e.g. that a callable was sampled and on which grid.
  virtual std::vector<std::string> notes() const { return {}; }
};

using SizingPtr = std::shared_ptr<const Sizing>;

SizingPtr constant_size(double s);

/// s = expression in x, y, z, with sound lower bounds by interval evaluation. Outside `bounds`: the value at
/// the nearest point of the box, so that what holds inside (positive, Lipschitz) holds everywhere.
SizingPtr expression_size(const std::string& expression, const Box3& bounds);

/// s(p) = min(cap, h0 + gradation * distance(p, surface)). cap may be infinite.
SizingPtr graded_from_surface(const TriangleMesh& surface, double h0, double gradation, double cap);

/// s(p) = min over points i of min(cap, h0[i] + gradation * |p - points[i]|). h0 has one entry or one a
/// point.
SizingPtr graded_from_points(std::vector<Vec3> points, std::vector<double> h0, double gradation, double cap);

/// Linear interpolation of nodal values on a background mesh; outside it, the value at the nearest point
/// of the mesh's boundary (stated in notes).
SizingPtr background_size(NodalField field);

/// The pointwise minimum of several (at least one).
SizingPtr minimum_size(std::vector<SizingPtr> sizes);

/// An opaque callable, sampled on a regular grid of about `samples` (at least 8) points over `bounds` and
/// interpolated trilinearly: the interpolant IS s, and notes() says so. Outside `bounds`: the value at the
/// nearest point of the box.
SizingPtr sampled_size(std::function<double(const Vec3&)> f, const Box3& bounds, std::size_t samples);

/// The same from one call of f for all points of the grid, which gives one value a point. What f throws
/// reaches the caller.
using ManyValues = std::function<std::vector<double>(const std::vector<Vec3>&)>;
SizingPtr sampled_size_at_once(const ManyValues& f, const Box3& bounds, std::size_t samples);

/// A g-Lipschitz function (g > 0) nowhere larger than s in `bounds`, and nearly the largest one: s is
/// bounded from below on cells as small as its steep places ask for; notes() states their number and how
/// much may be lost. s itself if it is g-Lipschitz. Outside `bounds`: the value at the nearest point.
SizingPtr limit_gradation(SizingPtr s, double g, const Box3& bounds);

}  // namespace unsliver
