/// \file
/// Checks against the domain and its sizes, which the caller hands over as callables and points.
#pragma once

#include "verify/context.hpp"
#include "verify/facet.hpp"
#include "verify/kd_tree.hpp"

namespace unsliver::verifier {

/// Findings "size": a sample p of the domain with no used vertex within size(p) (1 + 1e-12), a size that is
/// not positive, or no sample at all. Half of the samples are uniform in the mesh's box, half in its
/// tetrahedra, by volume; both filtered by inside(). Requires: size and inside.
void check_size(const Context& context, const KdTree& vertices, const std::vector<VertexId>& used);

/// Findings "cover": a point of must_cover in no (closed) tetrahedron, or strictly inside two ("overlap"),
/// both but for cover_tolerance.
void check_cover(const Context& context);

/// Findings "cover": just beyond a facet that the mesh ends at, a point of the domain is in no tetrahedron,
/// but for cover_tolerance. Requires: inside.
void check_holes(const Context& context, const std::vector<Facet>& boundary);

/// Findings "grading": a vertex nearer to another than grading_constant * lfs_lower_bound(v) (1 - 1e-12).
void check_grading(const Context& context, const KdTree& vertices, const std::vector<VertexId>& used);

}  // namespace unsliver::verifier
