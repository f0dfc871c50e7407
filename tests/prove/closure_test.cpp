// The finite parts of the closure theorem, and what happens without parents, centres or balance.
#include "prove/closure.hpp"

#include "differs.hpp"
#include "prove/cells.hpp"
#include "prove/closure_runs.hpp"
#include "prove/small_forest.hpp"

namespace unsliver::prover {
namespace {

TEST(ClosureA, Holds) { expect_as_recorded(prove_closure_a()); }

TEST(ClosureA, DiffersWithoutAParent) {
  ClosureA claim;
  claim.parents.pop_back();
  expect_differences(3, prove_closure_a(claim));
}

TEST(ClosureA, DiffersFromOtherNumbers) {
  expect_differences(1, prove_closure_a({.count = 495}));
  expect_differences(1, prove_closure_a({.largest_radius_sq = {6, 5}}));
  expect_differences(1, prove_closure_a({.bounds = {kAngle45, kAngle135, {5, 4}}}));
}

TEST(ClosureB, Holds) { expect_as_recorded(prove_closure_b()); }
TEST(ClosureB, Differs) {
  expect_differences(3, prove_closure_b({47, {1, 2}, {kAngle30, kAngle120, {3, 4}}}));
}

TEST(ClosureBrick, Holds) { expect_as_recorded(prove_closure_brick()); }

TEST(ClosureBrick, DiffersWithoutTheParentsOfParents) {
  EXPECT_GT(count_of_differences(prove_closure_brick({.keep_parents_of_parents_out = false})), 0);
}

TEST(ClosureBrick, DiffersFromOtherNumbers) {
  expect_differences(3,
                     prove_closure_brick({.edge_in_a_face = 5, .face_in_a_face = 1, .edge_in_an_edge = 0}));
}

TEST(SingleLattices, AreAsThePaperPrints) { expect_as_recorded(prove_single_lattices()); }
TEST(SingleLattices, Differ) { expect_differences(3, prove_single_lattices({17'022, 14'314, 14'199})); }

TEST(OctreeKeys, Hold) { expect_as_recorded(prove_octree_keys()); }
TEST(OctreeKeys, DifferWithoutCentres) { expect_differences(4, prove_octree_keys({.has_centers = false})); }
TEST(OctreeKeys, DifferFromOtherNumbers) {
  expect_differences(6, prove_octree_keys({319'224, 3'078'286, {kAngle30, kAngle120, {5, 4}}, true}));
}

TEST(BalancedOctree, IsAsRecorded) { expect_as_recorded(prove_balanced_octree()); }
TEST(BalancedOctree, Differs) {
  BalancedOctree claim;
  claim.face_least = 19'473;
  claim.all_types = 6211;
  claim.all_ratio_sq = {5, 4};
  claim.smallest_bad = 8;
  expect_differences(4 + 1, prove_balanced_octree(claim));  // one difference is on record
}

TEST(Counterexamples, AreTheSmallest) { expect_as_recorded(prove_counterexamples()); }
TEST(Counterexamples, Differ) {
  Counterexamples claim;
  claim.face_balance_splits = 3;
  claim.corners_only_vertices = 30;
  expect_differences(2, prove_counterexamples(claim));
}

// The smallest counterexample to balance across faces alone, as it stands: a root beside an edge at which its
// opposite is split twice.
TEST(Counterexamples, AnEdgeWithAFourfoldStep) {
  SmallForest forest(2, 2, 1);
  forest.split({{8, 0, 0}, 8});
  forest.split({{0, 8, 0}, 8});
  forest.split({{8, 8, 0}, 8});
  forest.split({{8, 8, 0}, 4});
  EXPECT_TRUE(forest.is_balanced_across_faces());
  EXPECT_FALSE(forest.is_balanced_across_edges());
  const Shape bad = delaunay_shape(forest.vertices(true));
  EXPECT_LT(bad.least, kAngle30);
  EXPECT_GT(bad.greatest, kAngle135);

  forest.split({{0, 0, 0}, 8});
  EXPECT_TRUE(forest.is_balanced_across_edges());
  const Shape good = delaunay_shape(forest.vertices(true));
  EXPECT_GE(good.least, kAngle30);
  EXPECT_LE(good.greatest, kAngle135);
}

TEST(ClosureRuns, Hold) { expect_as_recorded(prove_closure_runs()); }
TEST(ClosureRuns, Differ) { expect_differences(1, prove_closure_runs({.grading = 3'700})); }

}  // namespace
}  // namespace unsliver::prover
