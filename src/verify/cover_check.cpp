#include "verify/orientation.hpp"
#include "verify/sampling_checks.hpp"

namespace unsliver::verifier {
namespace {

/// What is known about a point so far.
struct Cover {
  std::uint32_t holder = kNoVertex;  ///< a tetrahedron that holds it
  bool inside = false;               ///< strictly
};

/// Findings for points that are not finite; the ids of the others.
std::vector<VertexId> finite_points(const Context& c) {
  std::vector<VertexId> ids;
  for (std::size_t i = 0; i < c.options.must_cover.size(); ++i) {
    if (is_finite(c.options.must_cover[i])) {
      ids.push_back(static_cast<VertexId>(i));
    } else {
      c.reporter.find("cover", {static_cast<std::int64_t>(i)},
                      [&] { return "point " + std::to_string(i) + " is not finite"; });
    }
  }
  return ids;
}

void find_overlap(const Context& c, VertexId point, std::uint32_t first, std::size_t second) {
  c.reporter.find("overlap", {first, static_cast<std::int64_t>(second)}, [&] {
    return "point " + full(c.options.must_cover[point]) + " is strictly inside both " +
           describe_tet(c.mesh, first) + " and " + describe_tet(c.mesh, second);
  });
}

}  // namespace

void check_cover(const Context& c) {
  const auto& points = c.options.must_cover;
  const std::vector<VertexId> ids = finite_points(c);
  const KdTree tree(points, ids);
  std::vector<Cover> cover(points.size());
  SignCounts counts;
  for (std::size_t t = 0; t < c.mesh.tets.size(); ++t) {
    c.pulse.beat();
    const Tet corners = c.mesh.corners(t);
    tree.visit_box(bounding_box(corners), [&](VertexId id, const Vec3& p) {
      const Side side = locate_in_tet(corners, p, counts);
      if (side == Side::kOutside) return;
      if (side == Side::kInside && cover[id].inside) find_overlap(c, id, cover[id].holder, t);
      if (!cover[id].inside) cover[id] = {static_cast<std::uint32_t>(t), side == Side::kInside};
    });
  }
  for (const VertexId id : ids) {
    if (cover[id].holder != kNoVertex) continue;
    c.reporter.find("cover", {id}, [&] {
      return "point " + std::to_string(id) + " at " + full(points[id]) + " is in no tetrahedron";
    });
  }
  c.reporter.report().exact_decisions += counts.exact;
  c.reporter.report().filtered_decisions += counts.filtered;
  const std::uint64_t missed = c.reporter.count("cover");
  c.reporter.line(
      "cover: " + grouped(points.size()) + " points, " +
      (missed == 0 ? "all in the union of the tetrahedra (exact)" : grouped(missed) + " NOT covered"));
}

}  // namespace unsliver::verifier
