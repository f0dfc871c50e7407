/// \file
/// Does a mesh of a periodic cell close upon itself? Judged from its points, its tetrahedra and what it says
/// of copies, with nothing of the generator's.
#pragma once

#include <vector>

#include "verify/context.hpp"
#include "verify/sites.hpp"

namespace unsliver::verifier {

/// Findings "periodic": arrays of a wrong length, a home that is none, a point that is not where its home and
/// its shift say, a cell that is no whole number of units. Puts copies of input vertices, which are judged
/// rounded, exactly where their rounded homes say. False: check_torus may not run.
bool align_copies(const Context& context, FramePlaces& places);

/// What the torus must be; requires an aligned mesh, `q` its places. Findings
/// - "periodic": a facet that is not in exactly two tetrahedra, on its two sides; a tetrahedron with a vertex
///   and its copy; two edges between the same vertices; an Euler characteristic other than 0; a volume other
///   than the cell's, exactly;
/// - "delaunay": the copy of a vertex beyond a facet inside the circumsphere (facets of two tetrahedra of the
///   mesh itself are left to check_tetrahedra). With options.delaunay_global also any copy of any vertex in
///   any circumsphere.
void check_torus(const Context& context, std::vector<Row<std::int64_t>> q);

/// Vertices as they are seen in the cell and within a quarter of its shortest side around it: the homes under
/// their own ids, and copies.
struct CopiesAround {
  std::vector<Vec3> points;  ///< by id; the mesh's copies are there, but under other ids
  std::vector<VertexId> ids, homes;
  std::vector<VertexId> home;                     ///< by id
  std::vector<std::array<std::int8_t, 3>> shift;  ///< by id
};
CopiesAround copies_around(const TetMesh& mesh, const std::vector<VertexId>& used);

}  // namespace unsliver::verifier
