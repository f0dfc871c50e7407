// Propositions 2 and 4, Lemmas 5 and 6, and the same with numbers that are wrong.
#include "prove/lattices.hpp"

#include "differs.hpp"

namespace unsliver::prover {
namespace {

TEST(Nesting, Holds) { expect_as_recorded(prove_nesting()); }

TEST(Nesting, DiffersWhereLatticesDoNotNest) {
  expect_differences(2, prove_nesting({is_bcc, is_even, is_even}));
  expect_differences(1, prove_nesting({is_even, is_even, is_bcc}));  // no proper subset
}

TEST(LatticeLengths, Hold) { expect_as_recorded(prove_lattice_lengths()); }

TEST(LatticeLengths, DifferFromOthers) {
  LatticeLengths claim;
  claim.sc_shortest_sq = {2, 1};
  claim.bcc_shortest_sq = {1, 2};
  claim.sc_covering_sq = {13, 16};
  claim.bcc_covering_sq = {1, 4};
  claim.bcc_delaunay.greatest = kAngle120;
  expect_differences(5, prove_lattice_lengths(claim));
}

TEST(Lemma5, Holds) { expect_as_recorded(prove_lemma_5()); }

TEST(Lemma5, DiffersFromOtherAngles) {
  Lemma5 claim;
  claim.least = Angle({749, 1000});
  expect_differences(1, prove_lemma_5(claim));
  claim = {};
  claim.greatest = kAngle120;
  expect_differences(2, prove_lemma_5(claim));
}

TEST(Lemma5, DiffersForLargerSpheres) {
  Lemma5 claim;
  claim.largest_radius_sq = {6, 4};
  expect_differences(3, prove_lemma_5(claim));
}

TEST(Lemma5, DiffersIfOneWorstCaseIsLeftOut) {
  Lemma5 claim;
  claim.worst = {kAngle135};
  claim.at_a_corner = 975;
  expect_differences(2, prove_lemma_5(claim));
}

TEST(Lemma6, Holds) { expect_as_recorded(prove_lemma_6()); }

TEST(Lemma6, Differs) {
  Lemma6 claim;
  claim.least = Angle({5, 8});
  claim.worst = 3;
  expect_differences(2, prove_lemma_6(claim));
  claim = {};
  claim.largest_radius_sq = {5, 16};
  expect_differences(2, prove_lemma_6(claim));
}

}  // namespace
}  // namespace unsliver::prover
