/// \file
/// Bounds watched on runs: how often one was met, and the worst.
#pragma once

#include "prove/enclosure.hpp"
#include "prove/finding.hpp"

namespace unsliver::prover {

struct Watched {
  int count = 0;
  bool holds = true;
  double worst_share = 0;  ///< of the bound, for people

  /// x_sq <= bound_sq, certainly?
  void see(const Enclosure& x_sq, const Enclosure& bound_sq);
  /// |ab| <= 2^k sqrt(bound_sq)?
  void see(const Point& a, const Point& b, int k, const Enclosure& bound_sq) {
    see(Fraction{dot(b - a, b - a), std::int64_t{1} << (2 * k)}, bound_sq);
  }
  void include(const Watched& other);
};

/// A bound that was never met does not hold: nothing was watched.
ProofPart watched_part(const std::string& claimed, const Watched& watched);

}  // namespace unsliver::prover
