/// \file
/// Random balanced forests without a domain: every tetrahedron is kept.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "octree/balance.hpp"
#include "octree/emission.hpp"

namespace unsliver::octree::test {

struct ForestPlan {
  Brick brick{6, {0, 0, 0}, {1, 1, 1}};
  int finest_exponent = 2;  ///< where random splits end
  double split_chance = 0.3;
  double center_chance = 0.3;  ///< of leaves that need no centre
};

/// Bricks of 1 to 12 cubes somewhere in the world, deep and shallow, sparse and dense; `number` is the seed.
inline ForestPlan plan_of(std::uint64_t number) {
  std::mt19937_64 random(number);
  ForestPlan plan;
  const int depth = 3 + int(number % 4);
  plan.brick.exponent = 1 + depth + int(random() % 20);
  plan.finest_exponent = plan.brick.exponent - depth;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    plan.brick.count[axis] = 1 + int(random() % (axis == 0 ? 3 : 2));
    plan.brick.lo[axis] = (std::int64_t(random() % 9) - 4) << plan.brick.exponent;
  }
  plan.split_chance = std::array{0.2, 0.3, 0.45, 0.6}[number / 4 % 4] / (depth > 4 ? 1.5 : 1.0);
  plan.center_chance = std::array{0.0, 0.3, 1.0}[number % 3];
  return plan;
}

/// Flags of a balanced forest's nodes are kInside everywhere, so that Emission keeps all.
inline Forest random_forest(const ForestPlan& plan, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto happens = [&](double chance) { return double(random() >> 11) * 0x1p-53 < chance; };
  Forest forest(plan.brick);
  for (NodeId n = 0; n < NodeId(forest.size()); ++n) {
    const bool is_root = forest[n].exponent == plan.brick.exponent;
    if (forest[n].exponent > plan.finest_exponent &&
        (happens(plan.split_chance) || (is_root && happens(0.8))))
      forest.split(n);
    forest[n].flags = std::uint8_t(kInside | (happens(plan.center_chance) ? kHasCenter : 0));
  }
  balance(forest, [&](const Cell& cell) {
    for (int i = 0; i < 8; ++i) {
      Node& child = forest[forest.child(cell, i).node];
      child.flags = std::uint8_t(kInside | (happens(plan.center_chance) ? kHasCenter : 0));
    }
  });
  return forest;
}

struct PointsAndTets {
  std::vector<Vec3> points;  ///< world coordinates
  std::vector<std::array<VertexId, 4>> tets;
};

inline PointsAndTets emit(Forest& forest, unsigned threads = 1) {
  Emission emission(forest, {threads, [](const Tet&) { return true; }, {}});
  emission.choose();
  emission.number();
  PointsAndTets result;
  result.points.resize(emission.vertex_count());
  emission.write_points([&](VertexId v, const Vec3& p, const Cell&, unsigned) { result.points[v] = p; });
  result.tets.resize(emission.tet_count());
  emission.write_tets(result.tets.data());
  return result;
}

/// Each with its corners in lexicographic order, all in order: comparable whatever the ids.
inline std::vector<Tet> sorted(std::vector<Tet> tets) {
  for (Tet& t : tets) std::sort(t.begin(), t.end(), lex_less);
  std::sort(tets.begin(), tets.end(), [](const Tet& a, const Tet& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lex_less);
  });
  return tets;
}

inline std::vector<Tet> as_tets(const PointsAndTets& mesh) {
  std::vector<Tet> tets;
  for (const auto& t : mesh.tets)
    tets.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]});
  return tets;
}

}  // namespace unsliver::octree::test
