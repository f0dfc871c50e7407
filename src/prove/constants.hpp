/// \file
/// The constants of the grading theorems: sections 4.2 and 5.2 of the paper, and parent closure.
///
/// Notation: inequality (1) is lfs(v) <= 2^k a for SC_k, 2^k b for BCC_k; c is that of Definition 2; sigma
/// and rho belong to the forbidden region. What is claimed with decimals is decided by enclosures, equalities
/// by the coefficients of roots.
#pragma once

#include "prove/enclosure.hpp"
#include "prove/finding.hpp"

namespace unsliver::prover {

/// The paper's irrational numbers.
struct Roots {
  Enclosure root2 = square_root(2), root3 = square_root(3), root5 = square_root(5), root6 = square_root(6);
  Enclosure sigma = (Enclosure(2) + root6) / Enclosure(4), rho = root3 * sigma;
};

/// 5.2.4 and 5.2.6.
struct Figure8Constants {
  explicit Figure8Constants(const Roots& r);
  Enclosure alpha, a, b;
};

/// All in thousandths. `grading` n: neighbours are at lfs / n or more.
struct GradingFigure5 {
  int grading = 6'701;
};
Finding prove_grading_figure_5(const GradingFigure5& claim = {});

/// 4.2.1: the c for which the size step keeps inequality (1).
struct SizeStep {
  int paper = 3'291;  ///< a / sqrt 3
  int sc_only = 2'791, both_lattices = 3'936;
};
Finding prove_size_step(const SizeStep& claim = {});

struct GradingFigure8 {
  int grading = 109'800;
  int alpha = 88'194, a = 108'724, b = 55'480;
  int c = 15'635;
};
Finding prove_grading_figure_8(const GradingFigure8& claim = {});

struct GradingClosure {
  int grading = 4'150, c = 1'987;
};
Finding prove_grading_closure(const GradingClosure& claim = {});

/// The size step of Figure 8 beside an input vertex u, around p in the middle of a cube, k = 0; in
/// hundredths.
struct Figure8SizeStep {
  int size = 90;
  Point u{-5, -5, -5};
};
Finding prove_figure_8_size_step(const Figure8SizeStep& claim = {});

}  // namespace unsliver::prover
