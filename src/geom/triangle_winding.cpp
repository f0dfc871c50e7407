#include "geom/triangle_winding.hpp"

#include <cmath>

namespace unsliver::geom {
namespace {

/// Cluster radii from which the series is used.
constexpr double kFar = 3;
constexpr double kInverse4Pi = 0.07957747154594767;

double farthest_corner_sq(const Vec3& p, const Box3& box) {
  Vec3 reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = std::max(p[axis] - box.lo[axis], box.hi[axis] - p[axis]);
  return norm_sq(reach);
}

Vec3 middle(const Triangle& t) { return t[0] + (1.0 / 3) * ((t[1] - t[0]) + (t[2] - t[0])); }

}  // namespace

void WindingField::add_first(Cluster& cluster, const Vec3& a, const Vec3& d) {
  cluster.trace += dot(a, d);
  cluster.square = cluster.square + Vec3{a.x * d.x, a.y * d.y, a.z * d.z};
  cluster.mixed = cluster.mixed + Vec3{a.y * d.z + a.z * d.y, a.z * d.x + a.x * d.z, a.x * d.y + a.y * d.x};
}

void WindingField::add_second(Cluster& cluster, const Vec3& a, const Vec3& d) {
  cluster.cube = cluster.cube + Vec3{a.x * d.x * d.x, a.y * d.y * d.y, a.z * d.z * d.z};
  cluster.skew_1 = cluster.skew_1 + Vec3{d.x * (a.y * d.x + 2 * a.x * d.y), d.y * (a.z * d.y + 2 * a.y * d.z),
                                         d.z * (a.x * d.z + 2 * a.z * d.x)};
  cluster.skew_2 = cluster.skew_2 + Vec3{d.x * (a.z * d.x + 2 * a.x * d.z), d.y * (a.x * d.y + 2 * a.y * d.x),
                                         d.z * (a.y * d.z + 2 * a.z * d.y)};
  cluster.all += 2 * (a.x * d.y * d.z + a.y * d.z * d.x + a.z * d.x * d.y);
  cluster.drift = cluster.drift + 2 * dot(a, d) * d + norm_sq(d) * a;
}

WindingField::WindingField(const BoxTree& tree, std::span<const Triangle> triangles)
    : clusters_(tree.nodes().size()) {
  std::vector<std::array<std::uint32_t, 2>> range(clusters_.size());  // of triangles, first to last + 1
  for (std::size_t n = clusters_.size(); n-- > 0;) {                  // children come after their parents
    const BoxTree::Node& node = tree.nodes()[n];
    range[n] = node.is_leaf() ? std::array{node.first, node.first + node.count}
                              : std::array{range[node.first][0], range[node.first + 1][1]};
    measure(n, node, triangles.subspan(range[n][0], range[n][1] - range[n][0]));
  }
}

void WindingField::measure(std::size_t n, const BoxTree::Node& node, std::span<const Triangle> triangles) {
  Cluster& cluster = clusters_[n];
  const Vec3 anchor = node.box.center();
  double total = 0;
  Vec3 weighted;
  for (const Triangle& t : triangles) {
    const double area = norm(area_vector(t));
    total += area;
    weighted = weighted + area * (middle(t) - anchor);
  }
  cluster.center = total > 0 ? anchor + (1 / total) * weighted : anchor;
  cluster.far_sq = kFar * kFar * farthest_corner_sq(cluster.center, node.box);
  for (const Triangle& t : triangles) {
    const Vec3 a = 0.5 * area_vector(t);
    cluster.dipole = cluster.dipole + a;
    add_first(cluster, a, middle(t) - cluster.center);
    // Second moments of a triangle: its corners with weight 1/12, its middle with 9/12.
    for (const Vec3& corner : t) add_second(cluster, (1.0 / 12) * a, corner - cluster.center);
    add_second(cluster, 0.75 * a, middle(t) - cluster.center);
  }
}

double WindingField::series(const Cluster& c, const Vec3& x, double distance_sq) {
  const double u = 1 / distance_sq;
  const double inverse_cube = u * std::sqrt(u);
  const Vec3 squares{x.x * x.x, x.y * x.y, x.z * x.z};
  const double first = dot(c.square, squares) + dot(c.mixed, {x.y * x.z, x.z * x.x, x.x * x.y});
  const double second = dot(c.cube, {x.x * squares.x, x.y * squares.y, x.z * squares.z}) +
                        dot(c.skew_1, {squares.x * x.y, squares.y * x.z, squares.z * x.x}) +
                        dot(c.skew_2, {squares.x * x.z, squares.y * x.x, squares.z * x.y}) +
                        c.all * x.x * x.y * x.z;
  return kInverse4Pi * inverse_cube *
         (dot(c.dipole, x) + c.trace - 3 * u * first + 1.5 * u * (5 * u * second - dot(c.drift, x)));
}

double WindingField::at(const Vec3& p, const BoxTree& tree, std::span<const Triangle> triangles) const {
  double winding = 0;
  const auto enter = [&](const BoxTree::Node& node) {
    const Cluster& cluster = clusters_[static_cast<std::size_t>(&node - tree.nodes().data())];
    const Vec3 to_center = cluster.center - p;
    const double distance_sq = norm_sq(to_center);
    if (distance_sq <= cluster.far_sq) return true;
    winding += series(cluster, to_center, distance_sq);
    return false;
  };
  tree.walk(enter, [&](std::uint32_t first, std::uint32_t count) {
    for (const Triangle& t : triangles.subspan(first, count)) winding += winding_of(t, p);
    return false;
  });
  return winding;
}

}  // namespace unsliver::geom
