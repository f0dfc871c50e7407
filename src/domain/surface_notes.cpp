#include "domain/surface_notes.hpp"

#include <fmt/format.h>

#include "base/plural.hpp"

namespace unsliver::domain {
namespace {

/// "3 boundary edges, 1 non-manifold edge": the defects that make a surface unclean.
std::string list_defects(const SurfaceDefects& d) {
  std::string list;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) list += (list.empty() ? "" : ", ") + plural(count, one, many);
  };
  add(d.boundary_edges.count, "boundary edge", "boundary edges");
  add(d.non_manifold_edges.count, "non-manifold edge", "non-manifold edges");
  add(d.inconsistent_edges.count, "edge between triangles of opposite orientation",
      "edges between triangles of opposite orientation");
  add(d.duplicate_triangles.count, "duplicate triangle", "duplicate triangles");
  add(d.self_intersections.count, "pair of intersecting triangles",
      d.self_intersections_complete ? "pairs of intersecting triangles"
                                    : "pairs of intersecting triangles or more");
  return list;
}

}  // namespace

std::vector<std::string> surface_notes(const SurfaceDefects& d, std::size_t turned) {
  std::vector<std::string> notes;
  if (turned > 0)
    notes.push_back(fmt::format("{} turned to face the same way as {} neighbours",
                                plural(turned, "triangle was", "triangles were"),
                                turned == 1 ? "its" : "their"));
  if (!d.clean())
    notes.push_back(
        fmt::format("the surface is {} ({} in {}); inside is decided by generalized winding number > 1/2 "
                    "within its bounding box, and every tetrahedron that touches a triangle is kept too",
                    d.closed() ? "closed but not clean" : "open", list_defects(d),
                    plural(d.components, "component", "components")));
  if (d.signed_volume < 0)
    notes.push_back("the surface encloses negative volume: its triangles were turned inside out");
  const std::size_t inward = d.signed_volume < 0 ? d.components - d.inward_components : d.inward_components;
  if (inward > 0)
    notes.push_back(
        fmt::format("{} of {} components face inward: they bound cavities, and are not filled where "
                    "nothing surrounds them",
                    inward, d.components));
  if (d.duplicate_points.count > 0)
    notes.push_back(fmt::format("{} taken for one with another at the same coordinates",
                                plural(d.duplicate_points.count, "point", "points")));
  if (d.degenerate_triangles.count > 0)
    notes.push_back(fmt::format("{} of zero area ignored",
                                plural(d.degenerate_triangles.count, "triangle", "triangles")));
  return notes;
}

}  // namespace unsliver::domain
