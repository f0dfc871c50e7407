// The octree path against CGAL: of the same points the same tetrahedra, ties included. Not only the
// tetrahedra come from outside here, the points do too: corners and centres of leaves, by a walk of our own.
#include "octree/octree.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "cgal.hpp"
#include "lattice/world.hpp"
#include "octree/fit.hpp"
#include "octree/growth.hpp"
#include "octree/random_forest.hpp"

namespace unsliver::octree {
namespace {

void collect_points(const Forest& forest, const Cell& cell, std::vector<Vec3>& points) {
  if (!forest[cell.node].is_leaf()) {
    for (int i = 0; i < 8; ++i) collect_points(forest, forest.child(cell, i), points);
    return;
  }
  const double side = double(cell.side());
  for (int i = 0; i < 8; ++i)
    points.push_back(cell.corner() + side * Vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  if (forest[cell.node].flags & kHasCenter) points.push_back(cell.center());
}

/// Every corner of a leaf and every centre that a leaf has, once, in lexicographic order.
std::vector<Vec3> points_of(const Forest& forest) {
  std::vector<Vec3> points;
  for_each_root(forest, [&](const Cell& root) { collect_points(forest, root, points); });
  std::sort(points.begin(), points.end(), lex_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::uint64_t forest_count() { return std::getenv("UNSLIVER_LONG") != nullptr ? 600 : 72; }

TEST(OctreeOracle, RandomForestsHaveTheTetrahedraOfCgal) {
  std::size_t tets = 0;
  for (std::uint64_t seed = 1; seed <= forest_count(); ++seed) {
    SCOPED_TRACE("forest " + std::to_string(seed));
    Forest forest = test::random_forest(test::plan_of(seed), seed);
    const std::vector<Vec3> points = points_of(forest);
    const std::vector<Tet> ours = test::as_tets(test::emit(forest));
    ASSERT_EQ(test::sorted(ours), test::sorted(oracle::cgal_tets(points)));
    tets += ours.size();
  }
  EXPECT_GT(tets, 100'000u);
}

struct Job {
  std::string name;
  DomainPtr domain;
  SizingPtr size;
};

std::vector<Job> jobs() {
  const double inf = std::numeric_limits<double>::infinity();
  const DomainPtr ball = make_ball({0.1, 0.2, 0.3}, 1);
  const DomainPtr box = make_box({{-1, 0, 2}, {1, 0.5, 3}});
  const DomainPtr torus =
      make_implicit("(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1", {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}});
  return {
      {"ball, constant", ball, constant_size(0.12)},
      {"ball, graded from a point", ball, graded_from_points({{0.3, 0.2, 0.1}}, {0.005}, 0.25, inf)},
      {"ball, formula", ball, expression_size("0.06 + 0.2 * abs(x)", ball->bounds())},
      {"box, constant", box, constant_size(0.07)},
      {"box, graded from a corner", box, graded_from_points({{1, 0.5, 3}}, {0.005}, 0.3, inf)},
      {"torus, constant", torus, constant_size(0.09)},
      {"torus, graded from a point", torus, graded_from_points({{1, 0, 0}}, {0.01}, 0.25, inf)},
  };
}

lattice::World world_of(const Job& job) {
  return lattice::World::fit(job.domain->bounds(), fit_radius(*job.domain, *job.size));
}

/// The forest that mesh_domain_octree makes for the job.
Forest forest_of(const Job& job, const lattice::World& world, bool all_centers) {
  LeafTest test(*job.domain, *job.size, world);
  Forest forest(brick_around(in_world(job.domain->bounds(), world)));
  GrowthSettings settings;
  settings.all_centers = all_centers;
  grow(forest, test, settings);
  const std::uint8_t center = all_centers ? kHasCenter : 0;
  balance(forest, [&](const Cell& cell) {
    for (int i = 0; i < 8; ++i) {
      const Cell child = forest.child(cell, i);
      forest[child.node].flags = std::uint8_t(test.flags(child, forest[child.node].flags) | center);
    }
  });
  return forest;
}

std::vector<Tet> in_world(const TetMesh& mesh, const lattice::World& world) {
  std::vector<Tet> tets;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    Tet corners = mesh.corners(t);
    for (Vec3& p : corners) p = world.to_world(p);
    tets.push_back(corners);
  }
  return tets;
}

/// CGAL's tetrahedra, of the forest's points, that meet the domain.
std::vector<Tet> expected_tets(const Job& job, const lattice::World& world, bool all_centers) {
  std::vector<Tet> tets = oracle::cgal_tets(points_of(forest_of(job, world, all_centers)));
  std::erase_if(tets, [&](Tet t) {
    for (Vec3& p : t) p = world.to_caller(p);
    return !job.domain->meets(t);
  });
  return tets;
}

TEST(OctreeOracle, MeshesOfDomainsHaveTheTetrahedraOfCgalThatMeetThem) {
  for (const Job& job : jobs())
    for (const bool all_centers : {false, true}) {
      SCOPED_TRACE(job.name + (all_centers ? ", all centres" : ""));
      OctreeOptions options;
      options.all_centers = all_centers;
      const TetMesh mesh = mesh_domain_octree(*job.domain, *job.size, options).mesh;
      const lattice::World world = world_of(job);
      ASSERT_EQ(mesh.frame->unit, world.unit());
      ASSERT_EQ(mesh.frame->origin, world.frame().origin);
      EXPECT_GT(mesh.tets.size(), 3000u);
      EXPECT_EQ(test::sorted(in_world(mesh, world)), test::sorted(expected_tets(job, world, all_centers)));
    }
}

}  // namespace
}  // namespace unsliver::octree
