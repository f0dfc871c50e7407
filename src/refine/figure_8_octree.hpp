/// \file
/// Figure 8 where an octree gives most of the vertices: the kernel holds the input vertices and what lies
/// around them, and the forest's own tetrahedra serve everywhere else.
///
/// Let B be the vertices of the forest without those too near to an input vertex (*removed*), and Q the input
/// vertices and what Figure 8 inserts. The mesh is the Delaunay tetrahedralization of B and Q. Its tetrahedra
/// - with a corner in Q, or with a removed point in their circumball, come from the kernel, which holds Q and
///   that part of B that ever was in conflict with such a tetrahedron (*lifted*): a tetrahedron of the kernel
///   whose circumball holds no point of B is one of the whole;
/// - all others have corners in B, and neither Q nor removed points in their circumballs: they are the
///   forest's own, as good as ever (docs/CLOSURE.md), whatever was inserted elsewhere.
#pragma once

#include "octree/octree.hpp"
#include "refine/refinement.hpp"

namespace unsliver::refine {

/// The mesh, complete. Requires input vertices, none of them beyond the domain's box, and a refinement with
/// strategy kOctree.
octree::OctreeResult figure_8_on_octree(Refinement& refinement, const Domain& domain, const Sizing& sizing,
                                        const octree::OctreeOptions& options, const Control& control);

}  // namespace unsliver::refine
