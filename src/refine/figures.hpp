/// \file
/// Which figure a strategy follows, in R^3 and on a torus alike.
#pragma once

#include "refine/closure.hpp"
#include "refine/figure_5.hpp"
#include "refine/figure_8.hpp"

namespace unsliver::refine {

/// Figure 5 without input vertices, Figure 8 beside them, or closure.
template <class R>
void run(R& r, Strategy strategy) {
  const bool literal = strategy == Strategy::kLiteral;
  if (strategy == Strategy::kClosure) return closure(r);
  if (r.inputs().empty())
    literal ? figure_5_literal(r) : figure_5_thrifty(r);
  else
    literal ? figure_8_literal(r) : figure_8_thrifty(r);
}

}  // namespace unsliver::refine
