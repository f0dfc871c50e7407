#include "prove/small_forest.hpp"

#include <algorithm>
#include <optional>

namespace unsliver::prover {
namespace {

constexpr std::int64_t kRootSide = 8, kLeastSide = 1;

Point corner_of(const Cube& cube, int c) { return cube.at + cube.side * Point{c & 1, c >> 1 & 1, c >> 2}; }

/// The dimension of what two cubes share, -1 if nothing.
int shared_dimension(const Cube& a, const Cube& b) {
  const Point a_end = corner_of(a, 7), b_end = corner_of(b, 7);
  const auto overlap = [](std::int64_t lo, std::int64_t hi, std::int64_t other_lo, std::int64_t other_hi) {
    return std::min(hi, other_hi) - std::max(lo, other_lo);
  };
  int dimension = 0;
  for (const std::int64_t length :
       {overlap(a.at.x, a_end.x, b.at.x, b_end.x), overlap(a.at.y, a_end.y, b.at.y, b_end.y),
        overlap(a.at.z, a_end.z, b.at.z, b_end.z)}) {
    if (length < 0) return -1;
    dimension += length > 0;
  }
  return dimension;
}

/// p is in the closed leaf and not one of its corners.
bool hangs_on(const Point& p, const Cube& leaf) {
  const Point d = p - leaf.at;
  const auto within = [&](std::int64_t c) { return c >= 0 && c <= leaf.side; };
  const auto at_end = [&](std::int64_t c) { return c == 0 || c == leaf.side; };
  return within(d.x) && within(d.y) && within(d.z) && !(at_end(d.x) && at_end(d.y) && at_end(d.z));
}

bool is_good(const Shape& shape) { return shape.within(kAngle30, kAngle135, {5, 4}); }

struct Counterexample {
  int splits, roots, vertices;
  Shape shape;
};

/// All forests that come from `forest` by this many splits of leaves.
std::set<std::set<Cube>> forests_after(const SmallForest& forest, int splits) {
  std::set<std::set<Cube>> all{forest.leaves()};
  for (int i = 0; i < splits; ++i) {
    std::set<std::set<Cube>> next;
    for (const std::set<Cube>& leaves : all)
      for (const Cube& leaf : leaves) {
        if (leaf.side == kLeastSide) continue;
        SmallForest split(leaves);
        split.split(leaf);
        next.insert(split.leaves());
      }
    all = std::move(next);
  }
  return all;
}

/// Of the forests that satisfy the condition, at most three splits deep, the first that is bad: by splits,
/// then by roots.
template <class Condition>
std::optional<Counterexample> smallest(bool with_centers, const Condition& condition) {
  constexpr int kMostSplits = 4;
  for (int splits = 0; splits <= kMostSplits; ++splits)
    for (const auto& [nx, ny] : {std::pair{1, 1}, {2, 1}, {3, 1}, {2, 2}})
      for (const std::set<Cube>& leaves : forests_after(SmallForest(nx, ny, 1), splits)) {
        const SmallForest forest(leaves);
        if (!condition(forest)) continue;
        const std::vector<Point> vertices = forest.vertices(with_centers);
        const Shape shape = delaunay_shape(vertices);
        if (!is_good(shape)) return Counterexample{splits, nx * ny, int(vertices.size()), shape};
      }
  return std::nullopt;
}

void add_parts(Finding& finding, const std::string& of, const Counterexample& claimed,
               const std::optional<Counterexample>& found) {
  const auto size = [](const Counterexample& c) {
    return fmt::format("{} splits, {} roots, {} vertices", c.splits, c.roots, c.vertices);
  };
  finding.push_back(part(fmt::format("{}: the smallest bad forest has {}", of, size(claimed)),
                         found ? size(*found) : "none",
                         found && found->roots == claimed.roots && found->splits == claimed.splits &&
                             found->vertices == claimed.vertices));
  finding.push_back(shape_part("its extremes: ", claimed.shape, found ? found->shape : Shape{}));
}

}  // namespace

SmallForest::SmallForest(int nx, int ny, int nz) {
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) leaves_.insert({kRootSide * Point{x, y, z}, kRootSide});
}

void SmallForest::split(const Cube& leaf) {
  const Cube half{leaf.at, leaf.side / 2};
  for (int c = 0; c < 8; ++c) leaves_.insert({corner_of(half, c), half.side});
  leaves_.erase(leaf);
}

bool SmallForest::is_balanced(int dimension) const {
  for (const Cube& a : leaves_)
    for (const Cube& b : leaves_)
      if (a.side > 2 * b.side && shared_dimension(a, b) == dimension) return false;
  return true;
}

std::vector<Point> SmallForest::vertices(bool with_centers) const {
  std::set<Point> points;
  for (const Cube& leaf : leaves_)
    for (int c = 0; c < 8; ++c) points.insert(corner_of(leaf, c));
  std::vector<Point> result(points.begin(), points.end());
  if (with_centers)
    for (const Cube& leaf : leaves_)
      if (std::any_of(points.begin(), points.end(), [&](const Point& p) { return hangs_on(p, leaf); }))
        result.push_back(corner_of({leaf.at, leaf.side / 2}, 7));
  return result;
}

Shape delaunay_shape(const std::vector<Point>& points) {
  Shape all;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      for (std::size_t c = b + 1; c < points.size(); ++c)
        for (std::size_t d = c + 1; d < points.size(); ++d) {
          const Tetrahedron t{points[a], points[b], points[c], points[d]};
          const auto sphere = Circumsphere::of(t);
          if (sphere && std::none_of(points.begin(), points.end(),
                                     [&](const Point& p) { return sphere->holds_inside(p); }))
            all.include(shape_of(t, *sphere));
        }
  return all;
}

Finding prove_counterexamples(const Counterexamples& claim) {
  Finding finding;
  // Forests that are balanced across edges too, with centres, are good by the theorem.
  add_parts(
      finding, "balance across faces alone",
      {claim.face_balance_splits, claim.face_balance_roots, claim.face_balance_vertices, claim.face_balance},
      smallest(true, [](const SmallForest& f) {
        return f.is_balanced_across_faces() && !f.is_balanced_across_edges();
      }));
  add_parts(
      finding, "corners without centres",
      {claim.corners_only_splits, claim.corners_only_roots, claim.corners_only_vertices, claim.corners_only},
      smallest(false, [](const SmallForest& f) {
        return f.is_balanced_across_faces() && f.is_balanced_across_edges();
      }));
  return finding;
}

}  // namespace unsliver::prover
