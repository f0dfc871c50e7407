/// \file
/// Propositions 2 and 4 of the paper, and Lemmas 5 and 6: finite statements about SC and BCC.
///
/// Notation: k = 0 throughout, for everything scales. Where BCC_0 occurs, coordinates are in halves of the
/// spacing: then SC_0 are the points with even coordinates, BCC_0 those whose coordinates are all even or all
/// odd.
#pragma once

#include "prove/finding.hpp"

namespace unsliver::prover {

inline bool is_even(const Point& p) { return ((p.x | p.y | p.z) & 1) == 0; }
/// In BCC, in units of half the spacing.
inline bool is_bcc(const Point& p) { return (((p.x ^ p.y) | (p.y ^ p.z)) & 1) == 0; }

/// Proposition 2: BCC_{k+1} < SC_k < BCC_k.
struct Nesting {
  /// The lattices from coarse to fine, as tests of points in halves of SC_0's spacing.
  bool (*coarse)(const Point&) = [](const Point& p) {
    return is_even(p) && is_bcc({p.x / 2, p.y / 2, p.z / 2});
  };
  bool (*middle)(const Point&) = is_even;
  bool (*fine)(const Point&) = is_bcc;
};
Finding prove_nesting(const Nesting& claim = {});

/// Proposition 4, squared, and what section 3 says of the Delaunay tetrahedra of BCC.
struct LatticeLengths {
  Fraction sc_shortest_sq{1, 1}, bcc_shortest_sq{3, 4};
  Fraction sc_covering_sq{3, 4}, bcc_covering_sq{5, 16};
  Shape bcc_delaunay{kAngle60, kAngle90, {15, 36}};
};
Finding prove_lattice_lengths(const LatticeLengths& claim = {});

/// Lemma 5 and Figure 3.
struct Lemma5 {
  Fraction largest_radius_sq{5, 4};
  Angle least = kAngle30, greatest = kAngle135;
  /// Up to symmetry, the tetrahedra that attain a bound: their greatest angles, least first.
  std::vector<Angle> worst = {kAngle120, kAngle135};
  int at_a_corner = 976;  ///< tetrahedra with a given corner
};
Finding prove_lemma_5(const Lemma5& claim = {});

/// Lemma 6 and Figure 4.
struct Lemma6 {
  Fraction largest_radius_sq{3, 4};
  Angle least{Fraction{2, 3}}, greatest{Fraction{-1, 3}};
  int worst = 1;  ///< tetrahedra that attain a bound, up to symmetry
};
Finding prove_lemma_6(const Lemma6& claim = {});

}  // namespace unsliver::prover
