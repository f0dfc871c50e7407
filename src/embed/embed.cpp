#include "unsliver/embed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/triangle_bvh.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

using Weights = std::array<double, 4>;

/// Points outside by no more than this share of the largest coordinate count as on the boundary.
constexpr double kRounding = 1e-12;
constexpr std::size_t kShown = 10;

double volume(const Tet& t) { return dot(cross(t[1] - t[0], t[2] - t[0]), t[3] - t[0]); }

/// None where the tetrahedron is flat.
std::optional<Weights> weights_in(const Tet& t, const Vec3& p) {
  const double whole = volume(t);
  if (whole == 0) return std::nullopt;
  Weights weights;
  for (std::size_t i = 0; i < 4; ++i) {
    Tet part = t;
    part[i] = p;
    weights[i] = volume(part) / whole;
  }
  return weights;
}

double longest_edge(const Tet& t) {
  double longest_sq = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) longest_sq = std::max(longest_sq, dist_sq(t[i], t[j]));
  return std::sqrt(longest_sq);
}

std::vector<Box3> boxes_of(const TetMesh& mesh) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) boxes.push_back(bounding_box(mesh.corners(t)));
  return boxes;
}

double largest_coordinate(const TetMesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

class Embedder {
 public:
  explicit Embedder(const TetMesh& mesh)
      : mesh_(mesh), tree_(boxes_of(mesh)), tolerance_(kRounding * largest_coordinate(mesh)) {}

  /// False where p is in no tetrahedron.
  bool add(const Vec3& p, Embedding& embedding) const {
    Best best;
    const auto enter = [&](const geom::BoxTree::Node& node) {
      return geom::dist_sq(p, node.box) <= tolerance_ * tolerance_;
    };
    tree_.walk(enter, [&](std::uint32_t first, std::uint32_t count) {
      for (std::uint32_t i = first; i < first + count; ++i) improve(best, tree_.order()[i], p);
      return false;
    });
    if (!(best.beyond <= tolerance_)) return false;
    embedding.tets.push_back(best.tet);
    const auto& v = mesh_.tets[best.tet];
    embedding.vertices.push_back({v[0], v[1], v[2], v[3]});
    embedding.weights.push_back(without_negatives(best.weights));
    return true;
  }

 private:
  struct Best {
    std::uint32_t tet = 0;
    Weights weights{};
    /// A bound of the distance from the point to the planes that it is beyond of; 0 inside.
    double beyond = std::numeric_limits<double>::infinity();
  };

  void improve(Best& best, std::uint32_t tet, const Vec3& p) const {
    const Tet corners = mesh_.corners(tet);
    const auto weights = weights_in(corners, p);
    if (!weights) return;
    const double least = *std::min_element(weights->begin(), weights->end());
    const double beyond = std::max(0.0, -least) * longest_edge(corners);
    if (beyond < best.beyond || (beyond == best.beyond && tet < best.tet)) best = {tet, *weights, beyond};
  }

  static Weights without_negatives(Weights weights) {
    double sum = 0;
    for (double& w : weights) sum += w = std::max(0.0, w);
    for (double& w : weights) w /= sum;
    return weights;
  }

  const TetMesh& mesh_;
  geom::BoxTree tree_;
  double tolerance_;
};

Error not_covered(std::span<const Vec3> points, const std::vector<std::size_t>& lost) {
  const Vec3& first = points[lost.front()];
  Error error(ErrorCode::kBadInput,
              fmt::format("{} of {} points are in no tetrahedron of the mesh, point {} at ({}, {}, {}) "
                          "first: embed into a mesh that covers them",
                          lost.size(), points.size(), lost.front(), first.x, first.y, first.z));
  for (std::size_t i = 0; i < std::min(lost.size(), kShown); ++i) {
    error.ids.push_back(static_cast<std::int64_t>(lost[i]));
    error.places.push_back(points[lost[i]]);
  }
  return error;
}

}  // namespace

Embedding embed_points(const TetMesh& mesh, std::span<const Vec3> points) {
  const Embedder embedder(mesh);
  Embedding embedding;
  std::vector<std::size_t> lost;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!embedder.add(points[i], embedding)) lost.push_back(i);
  if (!lost.empty()) throw not_covered(points, lost);
  return embedding;
}

}  // namespace unsliver
