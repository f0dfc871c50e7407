/// \file
/// The grading of parent closure, measured.
#pragma once

#include "prove/finding.hpp"

namespace unsliver::prover {

/// Sizes s(p) = min(s_max, s_i + |p - q_i|/c), so that lfs = c s exactly; vertices where balls B(p, s(p)) are
/// empty, and their parents.
struct ClosureRuns {
  int runs = 6;
  /// Neighbours are at lfs / n thousandths or more.
  int grading = 4'150;
};
Finding prove_closure_runs(const ClosureRuns& claim = {});

}  // namespace unsliver::prover
