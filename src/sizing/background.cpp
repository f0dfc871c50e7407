#include <fmt/format.h>

#include "sizing/background_mesh.hpp"
#include "sizing/boundary_field.hpp"
#include "sizing/checks.hpp"
#include "sizing/tet_linear.hpp"
#include "sizing/tree_search.hpp"
#include "unsliver/error.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A point counts as inside a tetrahedron when no barycentric coordinate is below minus this, so that points
/// on shared faces never fall between.
constexpr double kInsideTolerance = 1e-9;
constexpr double kSlack = 1e-9;

std::vector<Box3> tet_boxes(const TetMesh& mesh) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) boxes.push_back(bounding_box(mesh.corners(t)));
  return boxes;
}

class Background final : public Sizing {
 public:
  explicit Background(NodalField field)
      : field_(std::move(field)),
        boxes_(tet_boxes(field_.mesh)),
        tree_(boxes_),
        boundary_({field_.mesh.points, boundary_facets(field_.mesh), {}}, field_.values) {
    std::vector<double> least;
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
      const auto values = corner_values(t);
      least.push_back(*std::min_element(values.begin(), values.end()));
      const sizing::TetLinear f(field_.mesh.corners(t), values);
      if (!f.is_flat()) steepest_ = std::max(steepest_, norm(f.gradient()) * (1 + kSlack));
    }
    node_least_ = sizing::node_minima(tree_, least);
  }

  double at(const Vec3& p) const override {
    std::array<double, 4> weights{};
    const std::uint32_t tet = tet_around(p, weights);
    return tet == kNone ? boundary_.at(p) : interpolated(corner_values(tet), weights);
  }

  double lower_bound(const Box3& box) const override {
    const double within = least_within(box);
    return is_inside(box) ? within : std::min(within, boundary_.lower_bound(box));
  }

  /// Inside a convex mesh a segment leads from any point to any other; outside, the projection to a convex
  /// body lengthens no distance. Other shapes may jump across a gap.
  double lipschitz() const override { return boundary_.is_convex() ? steepest_ : kInfinity; }

  std::string describe() const override {
    return fmt::format("background mesh of {} points and {} tetrahedra", field_.mesh.points.size(),
                       field_.mesh.tets.size());
  }

  std::vector<std::string> notes() const override {
    std::vector<std::string> all{
        "outside the background mesh the size is that of the nearest point of its boundary"};
    if (!boundary_.is_convex()) {
      all.push_back("the background mesh is not convex (or not conforming), so the size may jump outside it");
    }
    return all;
  }

 private:
  static constexpr std::uint32_t kNone = sizing::Least{0}.item;

  std::array<double, 4> corner_values(std::size_t t) const {
    const auto& v = field_.mesh.tets[t];
    return {field_.values[v[0]], field_.values[v[1]], field_.values[v[2]], field_.values[v[3]]};
  }

  /// Does the mesh hold all of the box? True is certain.
  bool is_inside(const Box3& box) const {
    std::array<double, 4> weights;
    return tet_around(box.center(), weights) != kNone && boundary_.distance_lower_bound(box) > 0;
  }

  /// At most the size at any point of the box that is in the mesh.
  double least_within(const Box3& box) const {
    const Box3 reached = sizing::inflated(box, kSlack * (norm(box.center()) + box.diagonal()));
    const auto node = [&](std::uint32_t n) {
      return tree_.nodes()[n].box.overlaps(reached) ? node_least_[n] : kInfinity;
    };
    const auto item = [&](std::uint32_t t) {
      if (!boxes_[t].overlaps(reached)) return kInfinity;
      const sizing::TetLinear f(field_.mesh.corners(t), corner_values(t));
      return f.may_meet(reached) ? f.lower_bound(reached) : kInfinity;
    };
    return sizing::least_item(tree_, kInfinity, node, item).value * (1 - kSlack);
  }

  /// Weights cut to [0, 1] keep the result between the corner values.
  static double interpolated(const std::array<double, 4>& values, const std::array<double, 4>& weights) {
    double sum = 0, total = 0;
    for (int i = 0; i < 4; ++i) {
      const double w = std::clamp(weights[i], 0.0, 1.0);
      sum += w * values[i];
      total += w;
    }
    return sum / total;
  }

  /// The tetrahedron that holds p and its weights there, or kNone.
  std::uint32_t tet_around(const Vec3& p, std::array<double, 4>& weights) const {
    double least_outside = kInsideTolerance;
    const auto node = [&](std::uint32_t n) { return tree_.nodes()[n].box.contains(p) ? 0.0 : kInfinity; };
    const auto item = [&](std::uint32_t t) {
      if (!boxes_[t].contains(p)) return kInfinity;
      const sizing::TetLinear f(field_.mesh.corners(t), {});
      if (f.is_flat()) return kInfinity;
      const auto w = f.coordinates(p);
      const double outside = std::max(0.0, -*std::min_element(w.begin(), w.end()));
      if (outside < least_outside) least_outside = outside, weights = w;
      return outside;
    };
    return sizing::least_item(tree_, kInsideTolerance, node, item).item;
  }

  NodalField field_;
  std::vector<Box3> boxes_;
  geom::BoxTree tree_;
  sizing::BoundaryField boundary_;
  std::vector<double> node_least_;
  double steepest_ = 0;
};

Error at_vertex(std::size_t v, const Vec3& p, const std::string& fault) {
  Error error(ErrorCode::kBadInput,
              fmt::format("Background mesh, vertex {} at {}: {}.", v, sizing::to_text(p), fault));
  error.ids.push_back(static_cast<std::int64_t>(v));
  error.places.push_back(p);
  return error;
}

void check_field(const NodalField& field) {
  const auto& [mesh, values] = field;
  if (mesh.tets.empty()) throw Error(ErrorCode::kBadInput, "The background mesh has no tetrahedra.");
  if (values.size() != mesh.points.size()) {
    throw Error(ErrorCode::kBadInput,
                fmt::format("The background mesh has {} points but {} sizes; give one size a point.",
                            mesh.points.size(), values.size()));
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!is_finite(mesh.points[v])) throw at_vertex(v, mesh.points[v], "the coordinates must be finite");
    if (!(values[v] > 0 && std::isfinite(values[v]))) {
      throw at_vertex(v, mesh.points[v],
                      fmt::format("its size is {}, but it must be finite and above 0", values[v]));
    }
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (VertexId v : mesh.tets[t]) {
      if (v < mesh.points.size()) continue;
      Error error(ErrorCode::kBadInput,
                  fmt::format("Tetrahedron {} of the background mesh names vertex {}, but "
                              "there are {} vertices.",
                              t, v, mesh.points.size()));
      error.ids.push_back(static_cast<std::int64_t>(t));
      throw error;
    }
  }
}

}  // namespace

SizingPtr background_size(NodalField field) {
  check_field(field);
  if (boundary_facets(field.mesh).empty())
    throw Error(ErrorCode::kBadInput,
                "The background mesh has no boundary: each of its tetrahedra is there more than once.");
  return std::make_shared<Background>(std::move(field));
}

}  // namespace unsliver
