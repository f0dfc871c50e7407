/// \file
/// Generalized winding number of many triangles at once, by clusters (after Barill et al. 2018).
///
/// Far from a cluster its triangles act like their Taylor series about the cluster's centre: a dipole (the
/// area vector) and its first derivative. "Far" is kAccept cluster radii, which keeps the error of surfaces
/// far below 1e-3 (tested against the plain sum).
#pragma once

#include <span>
#include <vector>

#include "geom/triangle_bvh.hpp"
#include "geom/triangle_shape.hpp"

namespace unsliver::geom {

class WindingField {
 public:
  /// `triangles` are in the tree's order; both must outlive the field.
  WindingField(const BoxTree& tree, std::span<const Triangle> triangles);

  double at(const Vec3& p, const BoxTree& tree, std::span<const Triangle> triangles) const;

 private:
  struct Cluster {
    Vec3 center;        ///< mean by area
    Vec3 dipole;        ///< sum of area vectors
    Vec3 stretch;       ///< diagonal of the first moment: sum of area_vector_i * offset_i
    Vec3 shear;         ///< its symmetric parts yz, zx, xy (both halves added)
    double far_sq = 0;  ///< squared distance from which the series is used
    double area = 0;
  };
  static void add_moments(Cluster& cluster, const Vec3& area_vector, const Vec3& offset);
  static double series(const Cluster& cluster, const Vec3& to_center, double distance_sq);

  std::vector<Cluster> clusters_;
};

}  // namespace unsliver::geom
