#include <fmt/format.h>

#include "base/plural.hpp"
#include "domain/ranges.hpp"
#include "domain/side_grid.hpp"
#include "domain/surface_notes.hpp"
#include "domain/surface_orientation.hpp"
#include "domain/surface_region.hpp"
#include "domain/surface_topology.hpp"
#include "domain/tet_box.hpp"
#include "geom/triangle_shape.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

/// The triangles of positive area, turned inside out if `flip`.
TriangleMesh effective_surface(TriangleMesh surface, bool flip) {
  std::erase_if(surface.triangles, [&](const auto& v) {
    return norm_sq(geom::area_vector({surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]})) ==
           0;
  });
  if (flip)
    for (auto& v : surface.triangles) std::swap(v[1], v[2]);
  return surface;
}

Box3 bounds_of(const TriangleMesh& surface) {
  Box3 box;
  for (const auto& t : surface.triangles)
    for (const VertexId v : t) box.extend(surface.points[v]);
  return box;
}

/// The grid's answer is good enough from this many cells: at least a third of the distance.
constexpr double kCoarseSteps = 2;

class SurfaceDomain final : public Domain {
 public:
  SurfaceDomain(const TriangleMesh& surface, const std::vector<domain::EdgeUse>& uses,
                const SurfaceDefects& d, std::vector<std::string> notes)
      : clean_(d.clean()),
        bounds_(bounds_of(surface)),
        region_(surface, uses),
        grid_(surface, bounds_, region_),
        volume_(clean_ ? std::abs(d.signed_volume) : grid_.inside_volume()),
        description_(fmt::format("surface {}, {}, {}", surface.name,
                                 plural(surface.triangles.size(), "triangle", "triangles"),
                                 clean_ ? notes.empty() ? "closed and clean" : "closed, clean after repairs"
                                 : d.closed() ? "closed, not clean"
                                              : "open")),
        notes_(std::move(notes)) {}

  Box3 bounds() const override { return bounds_; }

  bool contains(const Vec3& p) const override { return bounds_.contains(p) && grid_.holds(p); }

  double clearance(const Vec3& p) const override {
    if (!bounds_.contains(p)) {
      const double to_box = domain::distance_to_box(p, bounds_);
      const bool far = to_box > bounds_.diagonal() || !region_.is_closed();
      return far ? to_box : std::max(to_box, region_.tree().clear_radius(p));
    }
    const double coarse = grid_.clearance(p);
    if (std::abs(coarse) > kCoarseSteps * grid_.cell()) return coarse;
    const double radius = region_.tree().clear_radius(p);
    if (region_.is_closed()) return grid_.holds(p) ? -radius : radius;
    const double fine = within_bounds(p, region_.clearance(p, radius));
    return std::abs(fine) > std::abs(coarse) ? fine : coarse;
  }

  int side_of_ball(const Vec3& p, double radius) const override {
    const double coarse = bounds_.contains(p) ? std::abs(grid_.clearance(p)) : 0;
    if (coarse < radius && region_.is_closed() && !region_.tree().is_clear(p, radius)) return 0;
    return Domain::side_of_ball(p, radius);
  }

  bool meets(const Tet& t) const override {
    if (!bounds_.overlaps(bounding_box(t))) return false;
    if (clean_ ? region_.tree().may_meet_interior(t) : region_.tree().may_meet(t)) return true;
    if (region_.is_closed()) return contains(domain::centroid(t));  // any point of it would do
    return region_.may_hold_part_of(t) && domain::interior_meets_box(t, bounds_);
  }

  double volume() const override { return volume_; }
  std::string describe() const override { return description_; }
  std::vector<std::string> notes() const override { return notes_; }

 private:
  /// The region of an open surface ends at the bounds.
  double within_bounds(const Vec3& p, double clearance) const {
    return clearance < 0 ? std::max(clearance, -domain::depth_in_box(p, bounds_)) : clearance;
  }

  bool clean_;
  Box3 bounds_;
  domain::SurfaceRegion region_;
  domain::SideGrid grid_;
  double volume_;
  std::string description_;
  std::vector<std::string> notes_;
};

}  // namespace

DomainPtr make_surface(TriangleMesh surface) {
  domain::require_valid_surface(surface);
  surface.triangles = domain::merged_triangles(surface, domain::merge_equal_points(surface.points));
  const std::size_t turned = domain::turn_to_agree(surface.points, surface.triangles);
  const SurfaceDefects defects = inspect_surface(surface);
  const std::string name = surface.name.empty() ? "the surface" : surface.name;
  if (defects.degenerate_triangles.count == surface.triangles.size())
    throw Error(ErrorCode::kBadInput,
                fmt::format("{} has no triangle of positive area ({} in all): nothing to mesh", name,
                            surface.triangles.size()));
  domain::require_usable_range(bounds_of(surface), name);
  const std::vector<domain::EdgeUse> uses = domain::edge_uses(surface.triangles);
  return std::make_shared<SurfaceDomain>(effective_surface(surface, defects.signed_volume < 0), uses, defects,
                                         domain::surface_notes(defects, turned));
}

}  // namespace unsliver
