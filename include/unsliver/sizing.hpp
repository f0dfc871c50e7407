/// \file
/// How fine: the sizing function s of Labelle's Definition 1, in the caller's units.
///
/// s(p) is a ball radius: in the final mesh every closed ball B(p, s(p)), p in the domain, holds a vertex.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "unsliver/domain.hpp"
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

  /// One line for the report, such as "constant 0.1".
  virtual std::string describe() const = 0;

  /// What a careful user must know, e.g. that a callable was sampled and on which grid.
  virtual std::vector<std::string> notes() const { return {}; }
};

using SizingPtr = std::shared_ptr<const Sizing>;

SizingPtr constant_size(double s);

/// s = expression in x, y, z, with sound lower bounds by interval evaluation over boxes inside `bounds`.
SizingPtr expression_size(const std::string& expression, const Box3& bounds);

/// s(p) = min(cap, h0 + gradation * distance(p, surface)). cap may be infinite.
SizingPtr graded_from_surface(const TriangleMesh& surface, double h0, double gradation, double cap);

/// s(p) = min over points i of min(cap, h0[i] + gradation * |p - points[i]|). h0 has one entry or one a
/// point.
SizingPtr graded_from_points(std::vector<Vec3> points, std::vector<double> h0, double gradation, double cap);

/// Linear interpolation of nodal values on a background mesh; outside it, the value at the nearest point
/// of the mesh's vertices (stated in notes).
SizingPtr background_size(NodalField field);

/// The pointwise minimum of several (at least one).
SizingPtr minimum_size(std::vector<SizingPtr> sizes);

/// An opaque callable, sampled on a regular grid of about `samples` points over `bounds` and interpolated
/// trilinearly: the interpolant IS s, and notes() says so.
SizingPtr sampled_size(std::function<double(const Vec3&)> f, const Box3& bounds, std::size_t samples);

/// The largest g-Lipschitz function that is nowhere larger than s on a grid over `bounds` (g > 0): s is
/// sampled from below (lower_bound on cells), limited, and interpolated; notes() states the grid.
SizingPtr limit_gradation(SizingPtr s, double g, const Box3& bounds);

}  // namespace unsliver
