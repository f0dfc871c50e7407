/// \file
/// Where to mesh: the domain Omega of Labelle's Figures 5 and 8, as a closed set in the caller's coordinates.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/types.hpp"

namespace unsliver {

/// A bounded closed set. All queries are const and safe to call from several threads.
///
/// Soundness contract: `clearance` and `meets` may err on one side only, as stated, so that the union of
/// the tetrahedra that `meets` keeps always covers the domain (a domain known by sampling alone promises
/// this to the sampling's resolution and says so in `notes`).
class Domain {
 public:
  virtual ~Domain() = default;

  /// A finite box that holds the domain.
  virtual Box3 bounds() const = 0;

  /// Is p in the domain?
  virtual bool contains(const Vec3& p) const = 0;

  /// A signed radius c, as large in magnitude as is cheap to find: the open ball of radius |c| about p lies
  /// wholly inside the domain when c < 0, wholly outside when c > 0. 0 = nothing is known.
  virtual double clearance(const Vec3& p) const = 0;

  /// +1 if the open ball about p lies certainly outside the domain, -1 if certainly inside, 0 if it may do
  /// neither. Often cheaper than `clearance`, because the search ends where the ball does.
  virtual int side_of_ball(const Vec3& p, double radius) const {
    const double c = clearance(p);
    return c >= radius ? 1 : c <= -radius ? -1 : 0;
  }

  /// True only if all of t certainly lies outside, as far as a few operations can tell. Unlike the balls
  /// above, a tetrahedron is told from a smooth domain nearby at once.
  virtual bool plainly_outside(const Tet&) const { return false; }

  /// False only if the interior of t is certainly disjoint from the domain.
  virtual bool meets(const Tet& t) const = 0;

  /// An approximation of the domain's volume, for estimates before the start (never for decisions).
  virtual double volume() const = 0;

  /// One line for the report, such as "ball, centre (0, 0, 0), radius 1".
  virtual std::string describe() const = 0;

  /// What a careful user must know: how inside was decided, to what resolution, defects found. May be empty.
  virtual std::vector<std::string> notes() const { return {}; }
};

using DomainPtr = std::shared_ptr<const Domain>;

/// A box with positive sides. \throws Error kBadInput on NaN, infinite or non-positive sides.
DomainPtr make_box(const Box3& box);

/// A ball. \throws Error kBadInput unless centre and radius are finite and radius > 0.
DomainPtr make_ball(const Vec3& center, double radius);

/// The set f(x, y, z) <= 0 inside `bounds`. `expression` is in x, y, z (see expression syntax in the docs).
/// Interval evaluation makes `meets` and `clearance` sound without sampling.
/// \throws Error kBadOption with the position of a syntax error; kBadInput if no inside point can be found.
DomainPtr make_implicit(const std::string& expression, const Box3& bounds);

/// The solid bounded by a triangle surface. A closed, consistently oriented, edge-manifold surface without
/// self-intersections is decided by its boundary; any other by generalized winding number > 1/2 (inside the
/// surface's bounding box) together with the surface itself (every tetrahedron that touches a triangle is
/// kept), and `notes` says so and why.
/// Before that, triangles that disagree with their neighbours are turned where that makes a patch agree, and
/// a surface of negative volume is turned inside out; notes too. \throws Error kBadInput for NaN coordinates,
/// no triangle of positive area, or zero extent.
DomainPtr make_surface(TriangleMesh surface);

/// One kind of defect: how often, and the first few places.
struct Defect {
  std::size_t count = 0;
  /// Vertex ids for vertices and edges, triangle ids for triangles and pairs of them; at most 10 entries.
  std::vector<std::vector<std::int64_t>> first;
};

/// What keeps a triangle surface from being the clean boundary of a solid. Vertices at equal coordinates
/// count as one vertex, named by its smallest id.
struct SurfaceDefects {
  std::size_t points = 0, triangles = 0;
  std::size_t components = 0;   ///< of triangles that hang together by vertices
  Defect duplicate_points;      ///< points at the place of an earlier one: harmless
  Defect degenerate_triangles;  ///< of zero area: ignored
  Defect duplicate_triangles;   ///< on the same three vertices as an earlier one
  Defect boundary_edges;        ///< in one triangle
  Defect non_manifold_edges;    ///< in three or more
  Defect inconsistent_edges;    ///< in two triangles that run along it in the same direction
  Defect self_intersections;    ///< pairs of triangles that meet outside their common vertices and edges
  bool self_intersections_complete = true;  ///< false: the search stopped at 10,000 pairs
  std::size_t inward_components = 0;        ///< of negative volume: cavities, or turned inside out
  double signed_volume = 0;                 ///< negative: the surface as a whole is inside out

  bool closed() const { return boundary_edges.count == 0; }
  /// The boundary decides: closed, edge-manifold, consistently oriented, free of self-intersections.
  bool clean() const {
    return closed() && non_manifold_edges.count == 0 && inconsistent_edges.count == 0 &&
           duplicate_triangles.count == 0 && self_intersections.count == 0;
  }
};

/// Counts the defects. O(n log n) for surfaces without many self-intersections.
/// \throws Error kBadInput for NaN or infinite coordinates, or an index out of range.
SurfaceDefects inspect_surface(const TriangleMesh& surface);

}  // namespace unsliver
