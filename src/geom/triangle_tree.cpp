#include "geom/triangle_tree.hpp"

#include <cmath>

#include "geom/triangle_bvh.hpp"
#include "geom/triangle_shape.hpp"
#include "geom/triangle_winding.hpp"

namespace unsliver::geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Box3> triangle_boxes(const TriangleMesh& surface) {
  std::vector<Box3> boxes;
  boxes.reserve(surface.triangles.size());
  for (const auto& v : surface.triangles)
    boxes.push_back(bounding_box(Triangle{surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]}));
  return boxes;
}

std::vector<Triangle> ordered_triangles(const TriangleMesh& surface, const BoxTree& tree) {
  std::vector<Triangle> triangles;
  triangles.reserve(surface.triangles.size());
  for (const std::uint32_t t : tree.order()) {
    const auto& v = surface.triangles[t];
    triangles.push_back({surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]});
  }
  return triangles;
}

}  // namespace

struct TriangleTree::Impl {
  explicit Impl(const TriangleMesh& surface)
      : tree(triangle_boxes(surface)), triangles(ordered_triangles(surface, tree)), winding(tree, triangles) {
    for (const Triangle& t : triangles) {
      slack = std::max(slack, closest_point_slack(t));
      const Vec3 side = bounding_box(t).size();
      longest = std::max(longest, norm(side));
    }
  }

  /// A sound lower bound from a computed distance (see closest_point_slack).
  double certainly(double distance) const {
    if (distance == kInfinity) return distance;
    return std::max(0.0, distance - 2 * slack * (longest + distance));
  }

  bool may_meet(const Tet& t, TetProbe::Extent extent) const {
    const TetProbe probe(t, extent);
    return tree.walk([&](const BoxTree::Node& node) { return probe.may_meet(node.box); },
                     [&](std::uint32_t first, std::uint32_t count) {
                       for (std::uint32_t i = first; i < first + count; ++i)
                         if (probe.may_meet(triangles[i])) return true;
                       return false;
                     });
  }

  /// Depth first, nearer child first. `on_leaf` returns the squared distance within which to go on looking.
  template <class OnLeaf>
  void approach(const Vec3& p, double within_sq, OnLeaf on_leaf, double& skipped_sq) const {
    struct Pending {
      std::uint32_t node;
      double dist_sq;
    };
    std::array<Pending, 40> pending;
    int size = 0;
    const auto& nodes = tree.nodes();
    if (nodes.empty()) return;
    pending[size++] = {0, dist_sq(p, nodes[0].box)};
    while (size > 0) {
      const Pending next = pending[--size];
      if (next.dist_sq > within_sq) {
        skipped_sq = std::min(skipped_sq, next.dist_sq);
        continue;
      }
      const BoxTree::Node& node = nodes[next.node];
      if (node.is_leaf()) {
        within_sq = on_leaf(node.first, node.count);
        continue;
      }
      Pending near{node.first, dist_sq(p, nodes[node.first].box)};
      Pending far{node.first + 1, dist_sq(p, nodes[node.first + 1].box)};
      if (far.dist_sq < near.dist_sq) std::swap(near, far);
      pending[size++] = far;
      pending[size++] = near;
    }
  }

  BoxTree tree;
  std::vector<Triangle> triangles;  ///< in the tree's order
  WindingField winding;
  double slack = 0, longest = 0;
};

TriangleTree::TriangleTree(const TriangleMesh& surface) : impl_(std::make_unique<Impl>(surface)) {}
TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

TriangleTree::Nearest TriangleTree::nearest(const Vec3& p, double max_distance) const {
  Nearest best{0, p, kInfinity};
  double best_sq = max_distance * max_distance, skipped_sq = kInfinity;
  const auto on_leaf = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Vec3 q = closest_point(impl_->triangles[i], p);
      const double q_sq = dist_sq(p, q);
      if (q_sq > best_sq || (q_sq == best_sq && best.distance < kInfinity)) continue;
      best_sq = q_sq;
      best = {impl_->tree.order()[i], q, std::sqrt(q_sq)};
    }
    return best_sq;
  };
  impl_->approach(p, best_sq, on_leaf, skipped_sq);
  return best;
}

double TriangleTree::clear_radius(const Vec3& p) const {
  constexpr double kEnough = 0.7;
  double best_sq = kInfinity, skipped_sq = kInfinity;
  const auto on_leaf = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i)
      best_sq = std::min(best_sq, dist_sq(p, closest_point(impl_->triangles[i], p)));
    return kEnough * kEnough * best_sq;
  };
  impl_->approach(p, kInfinity, on_leaf, skipped_sq);
  return impl_->certainly(std::sqrt(std::min(best_sq, skipped_sq)));
}

bool TriangleTree::is_clear(const Vec3& p, double radius) const {
  const auto reaches = [&](double distance_sq) { return impl_->certainly(std::sqrt(distance_sq)) < radius; };
  return !impl_->tree.walk([&](const BoxTree::Node& node) { return reaches(dist_sq(p, node.box)); },
                           [&](std::uint32_t first, std::uint32_t count) {
                             for (std::uint32_t i = first; i < first + count; ++i)
                               if (reaches(dist_sq(p, closest_point(impl_->triangles[i], p)))) return true;
                             return false;
                           });
}

double TriangleTree::distance_lower_bound(const Box3& box) const {
  const double radius = 0.5 * box.diagonal();
  const double at_center = impl_->certainly(nearest(box.center(), kInfinity).distance);
  const double magnitude = std::max(norm(box.lo), norm(box.hi));
  return std::max(0.0,
                  at_center - radius - 4 * std::numeric_limits<double>::epsilon() * (radius + magnitude));
}

double TriangleTree::winding_number(const Vec3& p) const {
  return impl_->winding.at(p, impl_->tree, impl_->triangles);
}

std::optional<int> TriangleTree::winding_gain(const Vec3& p, const Vec3& q) const {
  const Box3 path = bounding_box(Triangle{p, q, q});
  int total = 0;
  const bool ambiguous = impl_->tree.walk([&](const BoxTree::Node& node) { return node.box.overlaps(path); },
                                          [&](std::uint32_t first, std::uint32_t count) {
                                            for (std::uint32_t i = first; i < first + count; ++i) {
                                              const auto gain = geom::winding_gain(impl_->triangles[i], p, q);
                                              if (!gain) return true;
                                              total += *gain;
                                            }
                                            return false;
                                          });
  if (ambiguous) return std::nullopt;
  return total;
}

bool TriangleTree::may_meet(const Tet& t) const { return impl_->may_meet(t, TetProbe::Extent::kClosed); }

bool TriangleTree::may_meet_interior(const Tet& t) const {
  return impl_->may_meet(t, TetProbe::Extent::kInterior);
}

}  // namespace unsliver::geom
