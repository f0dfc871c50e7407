/// \file
/// The exact incremental Delaunay tetrahedralization (Bowyer and Watson): locate, carve the cavity, fill it
/// with a star.
///
/// Points are integers held in doubles, |c| < 2^48. The result is a function of the set of points alone: ties
/// are broken by the symbolic perturbation of exact/predicates.hpp, whatever the order of insertion, and no
/// tetrahedron is ever flat. A point may lie inside, on or outside the convex hull.
///
/// Four affinely independent points are needed for tetrahedra. Until they are there (single, collinear and
/// coplanar sets) `dimension()` is below 3, the vertices are kept in order, and there are no tetrahedra.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "delaunay/edge_map.hpp"
#include "delaunay/geometry.hpp"
#include "delaunay/store.hpp"

namespace unsliver::delaunay {

template <class Geometry>
class BasicTriangulation {
 public:
  using Point = typename Geometry::Point;
  using Space = typename Geometry::Space;
  template <class T>
  using Seen = typename Space::template Seen<T>;

  explicit BasicTriangulation(const Space& space = Space());

  /// --- Size and access. Vertex ids start at 1 in order of insertion; 0 is the vertex at infinity.
  int dimension() const { return dimension_; }
  std::size_t vertex_count() const { return vertices_.size() - 1; }
  std::size_t tet_count() const { return store_.tet_count(); }  ///< ghosts included
  std::size_t slot_count() const { return store_.slot_count(); }
  std::size_t bytes() const { return store_.bytes() + vertices_.bytes(); }
  bool alive(TetId t) const { return store_.alive(t); }
  bool is_ghost(TetId t) const { return store_.is_ghost(t); }
  bool is_finite(TetId t) const { return alive(t) && !is_ghost(t); }
  const TetRecord& tet(TetId t) const { return store_[t]; }
  const Space& space() const { return space_; }
  /// Of vertices and of corners (delaunay/space.hpp); in R^3 these are the same.
  static VertexId vertex_of(VertexId corner) { return Space::vertex_of(corner); }
  Seen<Point> point(VertexId v) const { return space_.place(vertices_[vertex_of(v)].point, v); }
  Seen<Vec3> position(VertexId v) const { return Geometry::position(point(v)); }
  Tet corners(TetId t) const {
    const auto& v = store_[t].v;
    return {position(v[0]), position(v[1]), position(v[2]), position(v[3])};
  }
  /// For loops over all slots: asks for the corners of a tetrahedron some steps ahead.
  void prefetch_ahead(TetId t) const {
    constexpr TetId kSteps = 8;
    if (t + kSteps < slot_count()) prefetch_corners(t + kSteps);
  }
  void prefetch(TetId t) const { store_.prefetch(t); }
  void prefetch_corners(TetId t) const {
    for (const VertexId v : store_[t].v) __builtin_prefetch(vertices_.begin() + vertex_of(v));
  }
  const PredicateCounts& counts() const { return counts_; }
  void reserve(std::size_t vertices, std::size_t tets);

  /// --- Insertion in one call.
  /// Inserts p, or returns the vertex that is already there. `hint` is any live tetrahedron, kNoTet = the
  /// last one made.
  VertexId insert(const Point& p, TetId hint = kNoTet);
  /// Inserts all points, in an order chosen for speed (rounds of growing size, each along a Hilbert curve).
  /// Returns the vertex of each point; equal points share one.
  std::vector<VertexId> insert_all(std::span<const Point> points);
  /// Inserts p, known to be in conflict with `in_conflict`: no location needed.
  VertexId insert_in_conflict(const Point& p, TetId in_conflict) {
    carve(p, in_conflict);
    return fill(p);
  }
  /// The tetrahedra made by the last insertion, ghosts included.
  std::span<const TetId> created() const { return created_; }

  /// --- The steps (dimension 3 only).
  /// A tetrahedron whose closure holds p, or a ghost beyond whose facet p lies: in conflict with p unless p
  /// is a vertex.
  TetId locate(const Point& p, TetId hint = kNoTet) const {
    Point copy = p;
    return walk_to(copy, hint);
  }
  /// The same, and p becomes its copy seen from the frame of that tetrahedron.
  TetId walk_to(Point& p, TetId hint = kNoTet) const;
  /// The corner of t at the position of p, or kNoVertex.
  VertexId corner_at(TetId t, const Point& p) const;
  /// Would inserting p remove t?
  bool in_conflict(TetId t, const Point& p) const;
  /// Finds the conflict region of p, starting from a member, from whose frame p is seen; must be followed by
  /// fill or abandon.
  void carve(const Point& p, TetId in_conflict);
  /// The conflict region and the corners of its boundary facets, valid between carve and fill or abandon.
  struct BoundaryFacet {
    VertexId v[3];  ///< (v, new vertex) is positively oriented; an infinite corner comes last
    Facet outer;    ///< the facet's other side, outside of the cavity
    [[no_unique_address]] typename Space::Shift frame;  ///< of v, seen from where the carving began
  };
  std::span<const TetId> cavity() const { return cavity_.span(); }
  /// Where corner v of cavity()[i] is, seen from where the carving began.
  Seen<Vec3> position_in_cavity(std::size_t i, VertexId v) const {
    return space_.seen_back(position(v), frames_[i]);
  }
  std::span<const BoundaryFacet> boundary() const { return boundary_.span(); }
  /// Replaces the cavity by the star of p; returns p's vertex.
  VertexId fill(const Point& p);
  /// Leaves everything as it was before carve.
  void abandon();

  /// --- On a torus, where there is no first tetrahedron to start from.
  /// Takes a tetrahedralization that is there already: points at their homes, and tetrahedra with corners
  /// (their vertices from 1 on) as positive as all others. Requires that none was taken or inserted before.
  void adopt(std::span<const Point> points, std::span<const std::array<VertexId, 4>> tets);

  /// Throws std::logic_error naming the first broken invariant (adjacency, orientation, local Delaunay). For
  /// tests.
  void check() const;

 private:
  struct VertexRecord {
    Point point;
    std::uint64_t number;  ///< scratch: see number_boundary_vertices
  };
  enum Mark : std::uint8_t { kUntested = 0, kDoomed = 1, kSpared = 2 };

  struct LocalFacet {
    std::uint32_t v[3];  ///< local numbers of the facet's corners
  };

  VertexId add_vertex(const Point& p);
  VertexId insert_low_dimensional(const Point& p);
  bool extends_basis(const Point& p) const;
  void start();
  void fill_with(VertexId v, typename Space::Shift from_home = {});
  int orient(VertexId a, VertexId b, VertexId c, const Point& p) const;
  void doom_neighbours(const TetRecord& tet, const Point& p, typename Space::Shift frame);
  void prefetch_apexes(const TetRecord& tet) const;
  void add_boundary_facets(const TetRecord& tet, typename Space::Shift frame);
  void number_boundary_vertices();
  void make_star(VertexId v, typename Space::Shift from_home);
  void link_star();
  void clear_spared_marks();
  void check_facet(TetId t, int slot) const;

  [[no_unique_address]] Space space_;
  Store store_;
  PodVector<VertexRecord> vertices_;
  int dimension_ = -1;
  std::vector<VertexId> basis_;  ///< affinely independent vertices, dimension_ + 1 of them
  std::map<Vec3, VertexId, decltype(&lex_less)> flat_{&lex_less};  ///< all vertices while dimension_ < 3

  PodVector<TetId> cavity_, spared_;
  [[no_unique_address]] typename Space::Shifts frames_;  ///< of the cavity, seen from where it began
  std::vector<TetId> created_;
  PodVector<BoundaryFacet> boundary_;
  std::vector<LocalFacet> local_;  ///< one per boundary facet
  std::uint64_t next_number_ = 1;
  EdgeMap edges_;
  mutable PredicateCounts counts_;
};

using Triangulation = BasicTriangulation<Unweighted>;
extern template class BasicTriangulation<Unweighted>;
using PeriodicTriangulation = BasicTriangulation<PeriodicUnweighted>;
extern template class BasicTriangulation<PeriodicUnweighted>;

}  // namespace unsliver::delaunay
