/// \file
/// Values at the vertices of a surface, linear on its triangles; every point of space takes the value at the
/// nearest point of the surface.
#pragma once

#include <vector>

#include "geom/triangle_bvh.hpp"
#include "geom/triangle_shape.hpp"
#include "geom/triangle_tree.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::sizing {

class BoundaryField {
 public:
  /// Requires triangles, and a positive, finite value for every vertex that one of them names.
  BoundaryField(const TriangleMesh& surface, const std::vector<double>& values);

  /// Does the surface bound a convex body? Then bounds are sharper, and the values outside as steep as on it.
  bool is_convex() const { return is_convex_; }

  double at(const Vec3& p) const;
  double distance_lower_bound(const Box3& box) const { return nearest_.distance_lower_bound(box); }
  /// At most the value at any point of the box. Tends to the least value among the points of the surface
  /// nearest to the box's centre as the box shrinks.
  double lower_bound(const Box3& box) const;

 private:
  struct Facet {
    geom::Triangle corners;
    std::array<double, 3> values;
    double slope;  ///< at least the length of the gradient; infinite where rounding may spoil it

    double at(const Vec3& p) const;
    double least() const { return std::min({values[0], values[1], values[2]}); }
  };
  static double slope_of(const geom::Triangle& corners, const std::array<double, 3>& values);

  std::vector<Facet> facets_;
  geom::TriangleTree nearest_;
  bool is_convex_;
  geom::BoxTree boxes_;
  std::vector<double> node_least_;
};

}  // namespace unsliver::sizing
