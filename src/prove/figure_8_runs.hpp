/// \file
/// Table 2, Lemmas 10 and 11, the chain of parents of 5.2.5 and Corollary 9, watched on runs of Figure 8.
#pragma once

#include "prove/figure_8.hpp"
#include "prove/finding.hpp"

namespace unsliver::prover {

struct Figure8Runs {
  int runs = 6;
  /// Bounds are multiplied by this: 1 is the paper.
  Fraction scale{1, 1};
  /// n(p(w')) is never null where the chain ends at a vertex of type 1.1 or 2.
  bool chain_ends_are_complete = true;
};
Finding prove_figure_8_runs(const Figure8Runs& claim = {});

}  // namespace unsliver::prover
