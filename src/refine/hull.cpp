#include "unsliver/hull.hpp"

#include <fmt/format.h>

#include <cmath>

#include "delaunay/triangulation.hpp"
#include "domain/ranges.hpp"
#include "lattice/input_sites.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

using delaunay::TetId;
using delaunay::Triangulation;

/// Integers for the kernel, and doubles that are exactly where the integers say. The steps along the axes may
/// differ: no plane cares.
class Grid {
 public:
  explicit Grid(const Box3& box) {
    for (int axis = 0; axis < 3; ++axis) {
      const double largest = std::max(std::abs(box.lo[axis]), std::abs(box.hi[axis]));
      exponents_[axis] = std::max(std::ilogb(box.longest_side()) - kSpanBits,
                                  std::ilogb(std::max(largest, box.longest_side())) - kFinestBit);
    }
    middle_ = steps(box.center());
  }

  /// The grid point nearest to p, counted in steps from the middle. Exact, being a small difference.
  Vec3 place(const Vec3& p) const { return steps(p) - middle_; }
  Vec3 point(const Vec3& place) const {
    Vec3 p = middle_ + place;
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], exponents_[axis]);
    return p;
  }

 private:
  static constexpr int kSpanBits = 46;  // places are 2^46 from the middle at most; the kernel takes 2^48
  // So far from the origin that this is what counts, all coordinates have the largest one's exponent or the
  // next: they are on the grid.
  static constexpr int kFinestBit = 53;

  Vec3 steps(Vec3 p) const {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::nearbyint(std::ldexp(p[axis], -exponents_[axis]));
    return p;
  }

  int exponents_[3];
  Vec3 middle_;
};

Box3 box_of(std::span<const Vec3> points) {
  if (points.empty()) throw Error(ErrorCode::kBadInput, "no points are given: they have no convex hull");
  Box3 box;
  for (std::size_t id = 0; id < points.size(); ++id) {
    box.extend(points[id]);
    if (is_finite(points[id])) continue;
    Error error(ErrorCode::kBadInput, fmt::format("point {} has a coordinate that is not a finite number: {}",
                                                  id, domain::format_point(points[id])));
    error.ids = {static_cast<std::int64_t>(id)};
    throw error;
  }
  return box;
}

/// In how many directions at right angles do the points spread by `least` or more? Each direction is that of
/// the point farthest from the first one, when what lies along the directions before is taken away.
int dimension_of(std::vector<Vec3> points, double least) {
  const Vec3 first = points.front();
  for (Vec3& p : points) p = p - first;
  for (int dimension = 0; dimension < 3; ++dimension) {
    const auto nearer = [](const Vec3& a, const Vec3& b) { return norm_sq(a) < norm_sq(b); };
    const Vec3 farthest = *std::max_element(points.begin(), points.end(), nearer);
    if (!(norm(farthest) >= least)) return dimension;
    const Vec3 direction = 1 / norm(farthest) * farthest;
    for (Vec3& p : points) p = p - dot(p, direction) * direction;
  }
  return 3;
}

void require_volume(std::size_t count, int dimension) {
  constexpr const char* kWhere[] = {"lie at one place", "lie on a line", "lie in a plane"};
  if (dimension == 3) return;
  throw Error(
      ErrorCode::kUnsupported,
      count == 1 ? "a single point's convex hull has no volume to mesh"
                 : fmt::format("the {} points {}, within {} of their extent: their convex hull has no volume "
                               "to mesh",
                               count, kWhere[dimension], lattice::kLeastSeparation));
}

/// The facets beyond which the kernel's ghosts are. A ghost's corners look outward.
TriangleMesh boundary_of(const Triangulation& mesh, const Grid& grid) {
  TriangleMesh hull;
  std::vector<VertexId> numbers(mesh.vertex_count() + 1, kNoVertex);
  const auto number_of = [&](VertexId v) {
    if (numbers[v] == kNoVertex) {
      numbers[v] = static_cast<VertexId>(hull.points.size());
      hull.points.push_back(grid.point(mesh.position(v)));
    }
    return numbers[v];
  };
  for (TetId t = 0; t < mesh.slot_count(); ++t) {
    if (!mesh.alive(t) || !mesh.is_ghost(t)) continue;
    const auto& v = mesh.tet(t).v;
    const VertexId a = number_of(v[0]), b = number_of(v[1]), c = number_of(v[2]);
    hull.triangles.push_back({a, b, c});
  }
  return hull;
}

}  // namespace

TriangleMesh convex_hull(std::span<const Vec3> points) {
  const Box3 box = box_of(points);
  if (box.longest_side() == 0) require_volume(points.size(), 0);
  domain::require_usable_range(box, "the set of points");
  const double least = lattice::kLeastSeparation * box.longest_side();
  require_volume(points.size(), dimension_of({points.begin(), points.end()}, least));
  const Grid grid(box);
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const Vec3& p : points) places.push_back(grid.place(p));
  Triangulation mesh;
  mesh.insert_all(places);
  TriangleMesh hull = boundary_of(mesh, grid);
  hull.name = fmt::format("convex hull of {} points", points.size());
  return hull;
}

}  // namespace unsliver
