// The constants, and Figure 8 watched.
#include "differs.hpp"
#include "prove/constants.hpp"
#include "prove/figure_8_runs.hpp"

namespace unsliver::prover {
namespace {

TEST(GradingFigure5, Holds) { expect_as_recorded(prove_grading_figure_5()); }
TEST(GradingFigure5, Differs) { expect_differences(1, prove_grading_figure_5({6'700})); }

TEST(SizeStep, ThePapersConstantIsTooLargeAndOursAreNot) { expect_as_recorded(prove_size_step()); }
TEST(SizeStep, Differs) {
  expect_differences(3, prove_size_step({.sc_only = 2'793, .both_lattices = 3'938}));
}
TEST(SizeStep, TheCorrectedConstantPassesWhereThePapersFails) {
  expect_differences(0, prove_size_step({.paper = 2'790}));
}

TEST(GradingFigure8, Holds) { expect_as_recorded(prove_grading_figure_8()); }
TEST(GradingFigure8, Differs) {
  expect_differences(5, prove_grading_figure_8({109'000, 88'190, 108'700, 55'490, 15'630}));
}

TEST(GradingClosure, Holds) { expect_as_recorded(prove_grading_closure()); }
TEST(GradingClosure, Differs) { expect_differences(2, prove_grading_closure({4'146, 1'990})); }

TEST(Figure8SizeStep, BreaksItsInvariantAsRecorded) { expect_as_recorded(prove_figure_8_size_step()); }
TEST(Figure8SizeStep, IsHarmlessWhereTheInputVertexIsFar) {
  expect_differences(0, prove_figure_8_size_step({.u = {-50, -50, -50}}));
}

TEST(Figure8Runs, AreAsRecorded) { expect_as_recorded(prove_figure_8_runs()); }

TEST(Figure8Runs, DifferFromTighterBounds) {
  const Finding finding = prove_figure_8_runs({.runs = 1, .scale = {1, 4}});
  const auto differs = [&](const std::string& start) {
    for (const ProofPart& part : finding)
      if (part.claimed.rfind(start, 0) == 0 && !part.holds) return true;
    return false;
  };
  for (const char* name : {"Lemma 10", "Lemma 11", "where it is null", "5.2.5: there"})
    EXPECT_TRUE(differs(name)) << name;
}

TEST(Figure8Runs, TheGapOfTheProofIsFound) {
  // Claimed to be open, it holds: the part says what is claimed, not what is expected.
  const Finding finding = prove_figure_8_runs({.runs = 1, .chain_ends_are_complete = false});
  expect_differences(0, finding);
}

TEST(Watched, AnInputVertexNearerThanItsLabelAllowsIsSeen) {
  Watched watched;
  watched.see(Point{0, 0, 0}, Point{0, 0, 8}, 2, 4);
  EXPECT_TRUE(watched.holds);
  watched.see(Point{0, 0, 0}, Point{0, 1, 8}, 2, 4);
  EXPECT_FALSE(watched.holds);
  EXPECT_EQ(watched.count, 2);
  EXPECT_FALSE(watched_part("", Watched{}).holds);
}

}  // namespace
}  // namespace unsliver::prover
