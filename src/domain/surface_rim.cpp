#include "domain/surface_rim.hpp"

#include "geom/triangle_shape.hpp"

namespace unsliver::domain {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr double kInverse4Pi = 0.07957747154594767;
constexpr double kRoundDown = 1 - 1e-12;

}  // namespace

std::vector<SurfaceRim::Edge> SurfaceRim::find(const std::vector<EdgeUse>& uses,
                                               const std::vector<Vec3>& points) {
  std::vector<Edge> edges;
  for (const EdgeUse& use : uses) {
    if (use.forward == use.backward) continue;
    const double surplus = std::abs(static_cast<double>(use.forward) - static_cast<double>(use.backward));
    edges.push_back({points[use.a], points[use.b], surplus});
  }
  return edges;
}

std::vector<Box3> SurfaceRim::boxes(const std::vector<Edge>& edges) {
  std::vector<Box3> boxes;
  boxes.reserve(edges.size());
  for (const Edge& e : edges) boxes.push_back(geom::bounding_box(geom::Triangle{e.a, e.b, e.b}));
  return boxes;
}

SurfaceRim::SurfaceRim(const std::vector<EdgeUse>& uses, const std::vector<Vec3>& points)
    : edges_(find(uses, points)), tree_(boxes(edges_)), strength_(tree_.nodes().size()) {
  for (std::size_t n = strength_.size(); n-- > 0;) {  // children come after their parents
    const auto& node = tree_.nodes()[n];
    if (!node.is_leaf()) strength_[n] = strength_[node.first] + strength_[node.first + 1];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Edge& e = edges_[tree_.order()[i]];
      strength_[n] += e.surplus * dist(e.a, e.b);
    }
  }
}

double SurfaceRim::gradient_bound(const Vec3& p, double radius) const {
  constexpr double kFar = 2;  // a node is taken whole beyond this many times its size
  double sum = 0;
  const auto add = [&](double strength, double surplus, double distance) {
    const double gap = kRoundDown * distance - radius;
    if (!(gap > 0)) return sum = std::numeric_limits<double>::infinity();
    return sum += std::min(strength / (gap * gap), surplus * kPi / gap);  // the latter: an endless line
  };
  const auto enter = [&](const geom::BoxTree::Node& node) {
    const double distance = std::sqrt(geom::dist_sq(p, node.box));
    if (distance - radius <= kFar * node.box.diagonal()) return true;
    add(strength_[static_cast<std::size_t>(&node - tree_.nodes().data())],
        std::numeric_limits<double>::infinity(), distance);
    return false;
  };
  tree_.walk(enter, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Edge& e = edges_[tree_.order()[i]];
      add(e.surplus * dist(e.a, e.b), e.surplus, dist(p, geom::closest_point({e.a, e.b, e.b}, p)));
    }
    return sum == std::numeric_limits<double>::infinity();
  });
  return kInverse4Pi * sum;
}

}  // namespace unsliver::domain
