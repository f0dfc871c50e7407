/// \file
/// Generalized winding number of many triangles at once, by clusters (after Barill et al. 2018).
///
/// Far from a cluster its triangles act like the Taylor series of the solid angle about the cluster's centre,
/// here up to second derivatives. "Far" is a few cluster radii; the error is tested against the plain sum.
#pragma once

#include <span>
#include <vector>

#include "geom/triangle_bvh.hpp"
#include "geom/triangle_shape.hpp"

namespace unsliver::geom {

class WindingField {
 public:
  /// `triangles` are in the tree's order; both are the ones to pass to `at`.
  WindingField(const BoxTree& tree, std::span<const Triangle> triangles);

  double at(const Vec3& p, const BoxTree& tree, std::span<const Triangle> triangles) const;

 private:
  /// With a the area vector and d the offset from the centre, integrated over the cluster:
  struct Cluster {
    Vec3 center;          ///< mean by area
    double far_sq = 0;    ///< squared distance from which the series is used
    Vec3 dipole;          ///< a
    double trace = 0;     ///< a . d
    Vec3 square, mixed;   ///< (a . x)(d . x) = square . (xx, yy, zz) + mixed . (yz, zx, xy)
    Vec3 cube;            ///< (a . x)(d . x)^2 = cube . (xxx, yyy, zzz) + skew_1 . (xxy, yyz, zzx)
    Vec3 skew_1, skew_2;  ///<                 + skew_2 . (xxz, yyx, zzy) + all . xyz
    double all = 0;
    Vec3 drift;  ///< 2 (a . d) d + |d|^2 a
  };
  static void add_first(Cluster& cluster, const Vec3& a, const Vec3& d);
  static void add_second(Cluster& cluster, const Vec3& a, const Vec3& d);
  static double series(const Cluster& cluster, const Vec3& to_center, double distance_sq);
  void measure(std::size_t n, const BoxTree::Node& node, std::span<const Triangle> triangles);

  std::vector<Cluster> clusters_;
};

}  // namespace unsliver::geom
