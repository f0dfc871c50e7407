/// \file
/// Where a surface is open: how fast the winding number can change away from the surface.
///
/// Across the surface the winding number w jumps; elsewhere its gradient comes from the rim alone, the edges
/// that the triangles do not traverse equally often in both directions. It is the field of a current along
/// the rim (Biot and Savart): |grad w(x)| <= 1/(4 pi) * sum over rim edges of m * integral of dl / |x - y|^2,
/// m the surplus of one direction. No rim: w is constant between triangles.
#pragma once

#include <vector>

#include "domain/surface_topology.hpp"
#include "geom/triangle_bvh.hpp"

namespace unsliver::domain {

class SurfaceRim {
 public:
  SurfaceRim(const std::vector<EdgeUse>& uses, const std::vector<Vec3>& points);

  bool empty() const { return edges_.empty(); }

  /// An upper bound of |grad w| over the ball about p, but for the surface itself; infinity if an edge may be
  /// in it.
  double gradient_bound(const Vec3& p, double radius) const;

 private:
  struct Edge {
    Vec3 a, b;
    double surplus = 1;
  };
  static std::vector<Edge> find(const std::vector<EdgeUse>& uses, const std::vector<Vec3>& points);
  static std::vector<Box3> boxes(const std::vector<Edge>& edges);

  std::vector<Edge> edges_;
  geom::BoxTree tree_;
  std::vector<double> strength_;  ///< per node: sum of surplus * length
};

}  // namespace unsliver::domain
