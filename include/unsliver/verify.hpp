/// \file
/// The independent judge. It shares no arithmetic, no predicate and no table with the generator: everything
/// is re-derived from the coordinates of the mesh with its own exact arithmetic (Boost.Multiprecision behind
/// its own interval filter).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/progress.hpp"

namespace unsliver {

/// The guarantee that is to hold for every tetrahedron. Squares are compared exactly: 30, 135 and sqrt(5)/2
/// are attained.
struct QualityGuarantee {
  double min_dihedral_deg = 30;
  double max_dihedral_deg = 135;
  double max_radius_edge = 1.118033988749895;  ///< sqrt(5)/2 is recognised and compared as 5/4 squared
};

/// What to check beyond the mesh itself. Plain callables and arrays in the caller's coordinates; empty = not
/// checked.
struct VerifyOptions {
  std::optional<QualityGuarantee> guarantee;
  bool delaunay =
      true;  ///< local (facet by facet) Delaunay property of facets between kept tetrahedra, exact
  bool delaunay_global = false;  ///< every vertex against every circumsphere by search: slow, for tests
  bool conforming_superset =
      true;  ///< every facet in 1 or 2 tetrahedra, boundary edge-manifoldness reported, no duplicates

  /// Is a point in the domain? With conforming_superset, four points just beyond each facet in one
  /// tetrahedron are asked about: those in the domain must be in some other tetrahedron (exact, but for
  /// cover_tolerance), or the mesh has a hole there.
  std::function<bool(const Vec3&)> inside;

  /// Size bound: for random points p with inside(p), a vertex lies within size(p) (1 + 1e-12). Needs
  /// `inside`. Where the domain has so little volume that none is met, the points of must_cover serve.
  std::function<double(const Vec3&)> size;
  std::size_t size_samples = 100000;

  /// Coverage: these points (surface vertices and samples, domain samples) must lie in the union of
  /// tetrahedra (closed, exact), and in the interior of one at most.
  std::vector<Vec3> must_cover;
  /// How far a point of must_cover may be off the domain, by the rounding of its coordinates. Two things are
  /// excused, both decided exactly with the corners and face centres of the cube of this half side around
  /// the point:
  /// - a point in no tetrahedron, if one of these is in some: with input vertices the mesh may end at the
  ///   surface;
  /// - a point strictly inside two tetrahedra, if not all of these are strictly inside both. Input vertices
  ///   are kept bit for bit, but the mesh is Delaunay for their places rounded to the grid. Where four of
  ///   them are coplanar in the surface, a sliver of the grid that does not meet the domain, and is not
  ///   kept, may be inverted where the vertices really are; its neighbours overlap there, outside the domain.
  double cover_tolerance = 0;

  /// Grading: distance from each vertex to its nearest neighbour >= grading_constant * lfs_lower_bound(v).
  std::function<double(const Vec3&)> lfs_lower_bound;
  double grading_constant = 0;

  std::uint64_t seed = 1;
  std::size_t max_findings = 20;
};

struct Finding {
  std::string
      check;  ///< "orientation", "conformity", "dihedral", "delaunay", "lattice", "size", "cover", ...
  std::string message;  ///< one sentence with ids, coordinates and numbers
  std::vector<std::int64_t> ids;
};

struct VerifyReport {
  bool ok = true;                   ///< no finding
  std::vector<Finding> findings;    ///< the first max_findings of each kind of check
  std::uint64_t finding_count = 0;  ///< all of them
  std::vector<std::string> checks;  ///< what was checked, one line each with its numbers, for the report
  std::uint64_t exact_decisions = 0, filtered_decisions = 0;
  double min_dihedral_deg = 0, max_dihedral_deg = 0,
         max_radius_edge = 0;  ///< achieved, correctly rounded to about 1e-12
  double volume = 0;
  double worst_size_ratio = 0;  ///< max over samples of dist(p, nearest vertex) / s(p)
  double worst_grading =
      0;  ///< min over vertices of nearest-neighbour distance / lfs lower bound; 0 if not checked
};

/// Never throws on a bad mesh: a bad mesh is a report with findings (index out of range, NaN included).
VerifyReport verify(const TetMesh& mesh, const VerifyOptions& options, const Control& control = {});

}  // namespace unsliver
