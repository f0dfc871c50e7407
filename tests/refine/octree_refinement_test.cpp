// What Figure 8 on octrees looks up, against plain searches.
#include "refine/octree_refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "delaunay/triangulation.hpp"
#include "octree/balance.hpp"
#include "octree/growth.hpp"
#include "octree/guest.hpp"
#include "refine/disturbers.hpp"

namespace unsliver::refine {
namespace {

using octree::Cell;
using octree::Forest;
using octree::NodeId;

struct LexLess {
  bool operator()(const Vec3& a, const Vec3& b) const { return lex_less(a, b); }
};
using PointSet = std::set<Vec3, LexLess>;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// An integer point of the cube.
  Vec3 in_cube(double lo, double side) {
    const double x = unit(), y = unit(), z = unit();
    return {std::floor(lo + side * x), std::floor(lo + side * y), std::floor(lo + side * z)};
  }

 private:
  std::mt19937_64 engine_;
};

constexpr int kRootExponent = 10;
constexpr double kRootSide = 1024;

/// 2 x 2 x 2 roots about the origin, split at random, more so near it; balanced.
Forest random_forest(Random& random) {
  Forest forest({kRootExponent, {-1024, -1024, -1024}, {2, 2, 2}});
  std::vector<Cell> open;
  octree::for_each_root(forest, [&](const Cell& root) { open.push_back(root); });
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const double share = std::min(1.0, 1.5 * double(cell.side()) / (200 + std::sqrt(norm_sq(cell.center()))));
    if (cell.exponent > 5 && (cell.exponent > 8 || random.unit() < share)) {
      forest.split(cell.node);
      for (int i = 0; i < 8; ++i) open.push_back(forest.child(cell, i));
    } else if (random.unit() < 0.7) {
      forest[cell.node].flags |= octree::kHasCenter;
    }
  }
  octree::balance(forest, [](const Cell&) {});
  return forest;
}

struct Leaf {
  Cell cell;
  NodeId parent;
};

std::vector<Leaf> leaves_of(const Forest& forest) {
  std::vector<Leaf> open, leaves;
  octree::for_each_root(forest, [&](const Cell& root) { open.push_back({root, root.node}); });
  while (!open.empty()) {
    const Leaf at = open.back();
    open.pop_back();
    if (forest[at.cell.node].is_leaf()) {
      leaves.push_back(at);
      continue;
    }
    for (int i = 0; i < 8; ++i) open.push_back({forest.child(at.cell, i), at.cell.node});
  }
  return leaves;
}

/// Each vertex of the forest with the exponent of its smallest leaf.
std::map<Vec3, int, LexLess> vertices_of(const Forest& forest) {
  const BulkPoints bulk(forest);
  std::map<Vec3, int, LexLess> vertices;
  for (const Leaf& leaf : leaves_of(forest))
    bulk.visit_vertices(leaf.cell, [&](const Vec3& p) {
      const auto at = vertices.emplace(p, leaf.cell.exponent).first;
      at->second = std::min(at->second, leaf.cell.exponent);
    });
  return vertices;
}

Inputs random_inputs(Random& random, std::size_t count, const Forest& forest) {
  PointSet places;
  while (places.size() < count) places.insert(random.in_cube(-0.8 * kRootSide, 1.6 * kRootSide));
  places.insert(vertices_of(forest).begin()->first + Vec3{1024, 1024, 1024});  // on a vertex
  std::vector<Vec3> list(places.begin(), places.end());
  std::vector<VertexId> ids(list.size());
  for (VertexId i = 0; i < ids.size(); ++i) ids[i] = i;
  lattice::InputSites sites;
  sites.first_point = sites.site_of = ids;
  return Inputs(std::move(sites), std::move(list));
}

double distance_to(const Cell& cell, const Vec3& q) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = cell.corner()[axis], hi = lo + double(cell.side());
    const double gap = std::max({0.0, lo - q[axis], q[axis] - hi});
    sum += gap * gap;
  }
  return std::sqrt(sum);
}

TEST(PointLookup, IsAMap) {
  Random random(1);
  PointLookup lookup;
  std::map<Vec3, VertexId, LexLess> expected;
  for (VertexId v = 0; v < 20000; ++v) {
    const Vec3 p = random.in_cube(-20, 40);
    const bool is_new = expected.emplace(p, v).second;
    if (v % 2 == 0)
      EXPECT_EQ(lookup.add(p, v), is_new);
    else
      EXPECT_EQ(lookup.find_or_add(p, v), expected.at(p));
  }
  for (int x = -25; x < 25; ++x)
    for (int y = -25; y < 25; ++y) {
      const Vec3 p{double(x), double(y), double(x ^ y)};
      const auto at = expected.find(p);
      EXPECT_EQ(lookup.find(p), at == expected.end() ? kNoVertex : at->second);
    }
}

TEST(BulkPoints, KnowsTheForestsVertices) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Forest forest = random_forest(random);
    const BulkPoints bulk(forest);
    const auto vertices = vertices_of(forest);
    for (const auto& [p, exponent] : vertices) EXPECT_EQ(bulk.exponent_at(p), exponent);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random.in_cube(-1500, 3000);
      const auto at = vertices.find(p);
      EXPECT_EQ(bulk.exponent_at(p), at == vertices.end() ? std::nullopt : std::optional(at->second));
      const double radius = 300 * random.unit();
      const auto is_even = [](const Vec3& q) { return lattice::canonical_level(q) % 2 == 0; };
      double nearest_sq = radius * radius * (1 + 1e-15);
      for (const auto& [q, exponent] : vertices)
        if (is_even(q)) nearest_sq = std::min(nearest_sq, dist_sq(p, q));
      const auto found = bulk.nearest_if(p, radius, is_even);
      ASSERT_EQ(found.has_value(), nearest_sq <= radius * radius);
      if (found) {
        EXPECT_EQ(dist_sq(*found, p), nearest_sq);
        EXPECT_TRUE(is_even(*found) && vertices.contains(*found));
      }
    }
  }
}

TEST(Surroundings, HoldAllThatIsNear) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Forest forest = random_forest(random);
    const Inputs inputs = random_inputs(random, 40, forest);
    const lattice::Level finest = seed % 2 == 0 ? lattice::kMinLevel : 2 * 4 + 1;
    const Surroundings around = gather_surroundings(forest, inputs, finest);
    const auto vertices = vertices_of(forest);
    PointSet kept, removed, expected_removed;
    for (const BulkVertex& v : around.kept) {
      EXPECT_EQ(vertices.at(v.place), v.exponent);
      EXPECT_TRUE(kept.insert(v.place).second);
    }
    for (const BulkVertex& v : around.removed) EXPECT_TRUE(removed.insert(v.place).second);
    for (const auto& [p, exponent] : vertices)
      if (!inputs.region_is_empty(p, finest_label(exponent, finest))) expected_removed.insert(p);
    EXPECT_EQ(removed, expected_removed);
    EXPECT_FALSE(removed.empty());
    ASSERT_EQ(around.sites.size(), inputs.places().size());
    for (std::size_t site = 0; site < around.sites.size(); ++site) {
      const auto shell = around.shell(around.sites[site]);
      const PointSet in_shell(shell.begin(), shell.end());
      EXPECT_EQ(in_shell.size(), shell.size());
      EXPECT_GE(around.sites[site].radius, around.least_radius);
      for (const auto& [p, exponent] : vertices) {
        const double distance = dist(p, inputs.places()[site]);
        const bool is_near = kept.contains(p) || removed.contains(p);
        EXPECT_TRUE(is_near || distance >= around.sites[site].radius);
        EXPECT_TRUE(is_near || in_shell.contains(p) || distance >= around.sites[site].shell_radius);
      }
    }
  }
}

/// Leaves without the flag: nobody needs to be asked about their vertices.
TEST(Surroundings, MarkTheLeavesThatTheyTouch) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Forest forest = random_forest(random);
    const Inputs inputs = random_inputs(random, 15, forest);
    const Surroundings around = gather_surroundings(forest, inputs, lattice::kMinLevel);
    PointSet near;
    for (const auto* list : {&around.kept, &around.removed})
      for (const BulkVertex& v : *list) near.insert(v.place);
    const BulkPoints bulk(forest);
    for (const Leaf& leaf : leaves_of(forest)) {
      if ((forest[leaf.cell.node].flags & octree::kVisited) != 0) continue;
      bulk.visit_vertices(leaf.cell, [&](const Vec3& p) {
        EXPECT_FALSE(near.contains(p));
        EXPECT_TRUE(inputs.region_is_empty(p, 2 * leaf.cell.exponent));
      });
    }
  }
}

TEST(Disturbers, AreKnownToTheLeavesTheyReach) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Forest forest = random_forest(random);
    std::vector<Disturber> all;
    for (VertexId group = 0; group < 8; ++group)
      for (int i = 0; i < 5; ++i) all.push_back({random.in_cube(-700, 1400), group});
    const Disturbers disturbers(forest, all);
    for (const Leaf& leaf : leaves_of(forest)) {
      const octree::Node& node = forest[leaf.cell.node];
      const double share = (node.flags & octree::kHasCenter) != 0 ? 0.5591 : 0.8661;
      const auto at = disturbers.at(leaf.cell.node);
      const PointSet listed(at.begin(), at.end());
      for (const Disturber& d : all)
        EXPECT_TRUE(listed.contains(d.place) ||
                    distance_to(leaf.cell, d.place) > share * double(leaf.cell.side()));
      EXPECT_EQ((node.flags & octree::kDisturbed) != 0, !listed.empty());
      EXPECT_TRUE(listed.empty() || (forest[leaf.parent].flags & octree::kDisturbed) != 0);
    }
  }
}

/// A tetrahedron of the kernel gives way to a point if inserting the point removes it.
TEST(GivesWay, AsTheKernelSays) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    delaunay::Triangulation mesh;
    for (int x = -2; x < 2; ++x)
      for (int y = -2; y < 2; ++y)
        for (int z = -2; z < 2; ++z)
          for (const double shift : {0.0, 32.0})
            mesh.insert({64. * x + shift, 64. * y + shift, 64. * z + shift});
    for (int i = 0; i < 200; ++i) {
      // Of multiples of 16 many are on spheres and some are corners.
      const double step = i % 2 == 0 ? 16 : 1;
      const Vec3 p = step * random.in_cube(-60 / step, 120 / step);
      for (delaunay::TetId t = 0; t < mesh.slot_count(); ++t) {
        if (!mesh.is_finite(t)) continue;
        const bool expected = mesh.corner_at(t, p) != kNoVertex || mesh.in_conflict(t, p);
        const Vec3 far{1000, 1000, 1000};
        EXPECT_EQ(octree::gives_way(mesh.corners(t), std::array{far, p}), expected);
      }
    }
  }
}

bool is_finite_at(const delaunay::Triangulation& mesh, TetId t, VertexId v) {
  return mesh.is_finite(t) && std::find(mesh.tet(t).v, mesh.tet(t).v + 4, v) != mesh.tet(t).v + 4;
}

/// A vertex that a size proof rests on, out of the mesh because its tetrahedra miss the domain, comes back
/// with all its tetrahedra, though it is one of the forest's.
TEST(OctreeRefinement, KeepsTheVerticesOfProofs) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.2);
  const std::vector<Vec3> points{{0.1, 0.2, 0.98}, {-0.9, 0.3, 0.3}, {0.02, -0.99, 0.03}, {0.7, 0.7, 0.1}};
  MeshOptions options;
  options.strategy = Strategy::kOctree;
  const Control control;
  Refinement r(*ball, *size, points, options, control);
  Forest forest(octree::brick_around(octree::in_world(ball->bounds(), r.world())));
  octree::grow(forest, octree::LeafTest(*ball, *size, r.world()), {});
  octree::balance(forest, [](const Cell&) {});
  OctreeRefinement refinement(r, forest);
  refinement.lift_surroundings();
  refinement.refine();
  const auto is_kept = [&](TetId t) {
    return std::binary_search(refinement.kept().begin(), refinement.kept().end(), t);
  };
  int brought_back = 0;
  const auto vertices = vertices_of(forest);
  for (VertexId v = 9; v <= r.mesh().vertex_count() && brought_back < 5; ++v) {
    bool is_used = r.clearance(v) < 0;
    for (const TetId t : refinement.kept()) is_used = is_used || is_finite_at(r.mesh(), t, v);
    if (is_used) continue;
    ++brought_back;
    r.rely_on(v);
    refinement.refine();
    for (TetId t = 0; t < r.mesh().slot_count(); ++t) {
      if (!is_finite_at(r.mesh(), t, v)) continue;
      EXPECT_TRUE(is_kept(t));
      EXPECT_FALSE(r.is_bad(t));
      for (const auto& [p, exponent] : vertices)
        EXPECT_FALSE(refinement.lifted_at(p) == kNoVertex && r.mesh().in_conflict(t, p) &&
                     r.inputs().region_is_empty(p, finest_label(exponent, lattice::kMinLevel)));
    }
  }
  EXPECT_EQ(brought_back, 5);
}

}  // namespace
}  // namespace unsliver::refine
