#include "geom/triangle_winding.hpp"

#include <cmath>

namespace unsliver::geom {
namespace {

constexpr double kAccept = 3;
constexpr double kInverse4Pi = 0.07957747154594767;

double farthest_corner_sq(const Vec3& p, const Box3& box) {
  Vec3 reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = std::max(p[axis] - box.lo[axis], box.hi[axis] - p[axis]);
  return norm_sq(reach);
}

}  // namespace

void WindingField::add_moments(Cluster& cluster, const Vec3& a, const Vec3& d) {
  cluster.stretch = cluster.stretch + Vec3{a.x * d.x, a.y * d.y, a.z * d.z};
  cluster.shear = cluster.shear + Vec3{a.y * d.z + a.z * d.y, a.z * d.x + a.x * d.z, a.x * d.y + a.y * d.x};
}

WindingField::WindingField(const BoxTree& tree, std::span<const Triangle> triangles)
    : clusters_(tree.nodes().size()) {
  for (std::size_t n = clusters_.size(); n-- > 0;) {  // children come after their parents
    const BoxTree::Node& node = tree.nodes()[n];
    Cluster& cluster = clusters_[n];
    const Vec3 anchor = node.box.center();
    Vec3 weighted;
    const auto part = [&](double area, const Vec3& center, const Vec3& area_vector) {
      cluster.area += area;
      weighted = weighted + area * (center - anchor);
      cluster.dipole = cluster.dipole + area_vector;
    };
    const auto leaf = triangles.subspan(node.is_leaf() ? node.first : 0, node.count);
    const auto middle = [&](const Triangle& t) {
      return anchor + (1.0 / 3) * ((t[0] - anchor) + (t[1] - anchor) + (t[2] - anchor));
    };
    for (const Triangle& t : leaf) {
      const Vec3 area = 0.5 * area_vector(t);
      part(norm(area), middle(t), area);
    }
    if (!node.is_leaf())
      for (const std::uint32_t child : {node.first, node.first + 1})
        part(clusters_[child].area, clusters_[child].center, clusters_[child].dipole);
    cluster.center = cluster.area > 0 ? anchor + (1 / cluster.area) * weighted : anchor;
    for (const Triangle& t : leaf) add_moments(cluster, 0.5 * area_vector(t), middle(t) - cluster.center);
    if (!node.is_leaf()) {
      for (const std::uint32_t child : {node.first, node.first + 1}) {
        const Cluster& c = clusters_[child];
        cluster.stretch = cluster.stretch + c.stretch;
        cluster.shear = cluster.shear + c.shear;
        add_moments(cluster, c.dipole, c.center - cluster.center);
      }
    }
    cluster.far_sq = kAccept * kAccept * farthest_corner_sq(cluster.center, node.box);
  }
}

double WindingField::series(const Cluster& cluster, const Vec3& d, double distance_sq) {
  const double inverse_sq = 1 / distance_sq;
  const double inverse_cube = inverse_sq * std::sqrt(inverse_sq);
  const Vec3 squares{d.x * d.x, d.y * d.y, d.z * d.z}, mixed{d.y * d.z, d.z * d.x, d.x * d.y};
  const double trace = cluster.stretch.x + cluster.stretch.y + cluster.stretch.z;
  const double bend = dot(cluster.stretch, squares) + dot(cluster.shear, mixed);
  return kInverse4Pi * inverse_cube * (dot(cluster.dipole, d) + trace - 3 * bend * inverse_sq);
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
