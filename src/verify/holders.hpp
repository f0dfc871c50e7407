/// \file
/// Which tetrahedra hold a point, exactly.
#pragma once

#include "verify/context.hpp"
#include "verify/kd_tree.hpp"
#include "verify/orientation.hpp"

namespace unsliver::verifier {

inline void add_counts(const Context& c, const SignCounts& counts) {
  c.reporter.report().exact_decisions += counts.exact;
  c.reporter.report().filtered_decisions += counts.filtered;
}

/// Visits every pair of a tetrahedron and a point, one of these ids, that it holds: found(id, tetrahedron,
/// strictly inside).
template <class Found>
void visit_holders(const Context& c, const std::vector<Vec3>& points, const std::vector<VertexId>& ids,
                   const Found& found) {
  if (ids.empty()) return;
  const KdTree tree(points, ids);
  SignCounts counts;
  for (std::uint32_t t = 0; t < c.mesh.tets.size(); ++t) {
    c.pulse.beat();
    const Tet corners = c.mesh.corners(t);
    tree.visit_box(bounding_box(corners), [&](VertexId id, const Vec3& p) {
      const Side side = locate_in_tet(corners, p, counts);
      if (side != Side::kOutside) found(id, t, side == Side::kInside);
    });
  }
  add_counts(c, counts);
}

/// The corners and the middles of the faces of the cube of half side cover_tolerance about p.
std::vector<Vec3> around(const Context& c, const Vec3& p);

/// Those of the ids whose points are missed by all (closed) tetrahedra, and by more than the tolerance.
std::vector<VertexId> uncovered(const Context& c, const std::vector<Vec3>& points,
                                const std::vector<VertexId>& ids);

/// The same where it is known that no tetrahedron holds the points themselves.
std::vector<VertexId> missed_by_more(const Context& c, const std::vector<Vec3>& points,
                                     const std::vector<VertexId>& missed);

}  // namespace unsliver::verifier
