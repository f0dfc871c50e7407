#include "delaunay/triangulation.hpp"

#include "delaunay/hilbert.hpp"

// One textbook step of Bowyer-Watson a file; one translation unit, so that the predicates inline into the
// loops.
#include "delaunay/adopt.ipp"
#include "delaunay/carve.ipp"
#include "delaunay/check.ipp"
#include "delaunay/fill.ipp"
#include "delaunay/locate.ipp"
#include "delaunay/start.ipp"

namespace unsliver::delaunay {

template <class Geometry>
BasicTriangulation<Geometry>::BasicTriangulation(const Space& space) : space_(space) {
  add_vertex(Point{});  // the vertex at infinity; its position is never read
}

template <class Geometry>
void BasicTriangulation<Geometry>::reserve(std::size_t vertices, std::size_t tets) {
  vertices_.reserve(vertices + 1);
  store_.reserve(tets);
}

template <class Geometry>
VertexId BasicTriangulation<Geometry>::add_vertex(const Point& p) {
  vertices_.push_back({p, 0});
  return static_cast<VertexId>(vertices_.size() - 1);
}

template <class Geometry>
VertexId BasicTriangulation<Geometry>::insert(const Point& p, TetId hint) {
  if (dimension_ < 3) return insert_low_dimensional(p);
  Point q = p;
  const TetId t = walk_to(q, hint);
  const VertexId existing = corner_at(t, q);
  return existing != kNoVertex ? vertex_of(existing) : insert_in_conflict(q, t);
}

template <class Geometry>
std::vector<VertexId> BasicTriangulation<Geometry>::insert_all(std::span<const Point> points) {
  std::vector<Vec3> positions;
  positions.reserve(points.size());
  for (const Point& p : points) positions.push_back(Geometry::position(p));
  std::vector<VertexId> ids(points.size());
  for (std::uint32_t i : insertion_order(positions)) ids[i] = insert(points[i]);
  return ids;
}

template class BasicTriangulation<Unweighted>;
template class BasicTriangulation<PeriodicUnweighted>;

}  // namespace unsliver::delaunay
