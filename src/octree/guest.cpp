#include "octree/guest.hpp"

#include <algorithm>

#include "exact/predicates.hpp"
#include "geom/tetrahedron.hpp"

namespace unsliver::octree {

/// Tetrahedra of the forest are round: seen from a corner their spheres are known to 1e-12, so exact
/// predicates are for the points that are next to them.
bool gives_way(const Tet& t, std::span<const Vec3> points) {
  constexpr double kDoubt = 1e-9;
  if (points.empty()) return false;
  const geom::Sphere sphere = geom::circumsphere({Vec3{0, 0, 0}, t[1] - t[0], t[2] - t[0], t[3] - t[0]});
  return std::any_of(points.begin(), points.end(), [&](const Vec3& p) {
    const double distance_sq = dist_sq(p - t[0], sphere.center), doubt = kDoubt * sphere.radius_sq;
    if (std::abs(distance_sq - sphere.radius_sq) > doubt) return distance_sq < sphere.radius_sq;
    exact::StageCounts counts;
    return std::find(t.begin(), t.end(), p) != t.end() ||
           exact::insphere_perturbed(t[0], t[1], t[2], t[3], p, counts) > 0;
  });
}

}  // namespace unsliver::octree
