/// \file
/// Decides the signs of one tetrahedron: in doubles where their error cannot matter, else in integers.
///
/// Stages. Differences of few significant bits (the normal case on a lattice, where ties are common) make
/// every double operation exact, so the result is the truth, zero included. Otherwise the result is trusted
/// beyond a forward error bound (derived in docs/VERIFY.md), and within it 128-bit or big integers decide.
#pragma once

#include <optional>

#include "verify/bounds.hpp"
#include "verify/shape.hpp"
#include "verify/sites.hpp"

namespace unsliver::verifier {

/// A tetrahedron as the judge sees it, in doubles.
struct Candidate {
  std::array<VertexId, 4> v;
  Shape<double> shape;
  std::uint64_t spread = 0;  ///< of the differences, see Sites::difference
  double reach = 0;          ///< largest component of the differences
  int orientation = 0;
};

/// Measures in doubles, for the extremes of the report.
struct Measures {
  double largest_cot = 0, smallest_cot = 0;  ///< signed cot^2 of the smallest and the largest dihedral angle
  double ratio_sq = 0;
};

/// The sign of each quality minus its bound: > 0 violated, 0 attained, < 0 or no bound fine.
struct Verdict {
  int min_angle = -1, max_angle = -1, ratio = -1;
};

/// Angles in degrees and the radius-edge ratio, to about 1e-14.
struct FineMeasures {
  double min_deg = 0, max_deg = 0, ratio = 0;
};

class Judge {
 public:
  /// Keeps a reference to `sites`.
  Judge(const Sites& sites, const Bounds& bounds) : sites_(sites), bounds_(bounds) {}

  /// Reads the corners and decides the orientation.
  Candidate candidate(const std::array<VertexId, 4>& v);
  /// Requires: orientation not 0.
  Verdict quality(const Candidate& c);
  Measures measures(const Candidate& c) const;
  /// +1 if vertex e is strictly inside the circumsphere, 0 on it, -1 outside. Requires: orientation not 0.
  int in_sphere(const Candidate& c, VertexId e);

  /// From exact integers; all angles of a flat tetrahedron count as 0 and 180, its ratio as infinite.
  FineMeasures fine_measures(const std::array<VertexId, 4>& v) const;

  std::uint64_t exact_decisions() const { return exact_; }
  std::uint64_t filtered_decisions() const { return filtered_; }

 private:
  /// The sign of a value known up to `error`, counted; nothing if the error could change it.
  std::optional<int> settled(double value, double error) {
    if (!(std::abs(value) > error || error == 0)) return std::nullopt;
    ++filtered_;
    return sign(value);
  }
  std::optional<Verdict> quality_in_doubles(const Candidate& c);
  template <class T>
  Verdict quality_in_integers(const Candidate& c);
  template <class T>
  int in_sphere_in_integers(const Candidate& c, VertexId e) const;

  const Sites& sites_;
  Bounds bounds_;
  std::uint64_t exact_ = 0, filtered_ = 0;
};

}  // namespace unsliver::verifier
