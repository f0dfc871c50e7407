/// \file
/// The finite parts of the parent-closure theorem (docs/CLOSURE.md), and the paper's single lattices.
///
/// Notation: the finest corner v is the origin, k = 0. A tetrahedron counts if certain points, v's parents
/// above all, are not inside its circumball.
#pragma once

#include "prove/finding.hpp"

namespace unsliver::prover {

/// Case (A): v in SC_0 but not in BCC_1, the middle of an edge or a face along axis 1.
struct ClosureA {
  int count = 496;
  Fraction largest_radius_sq{5, 4};
  Shape bounds{kAngle30, kAngle135, {5, 4}};
  /// The parents, all of which are kept out.
  std::vector<Point> parents = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}, {0, 1, -1}, {0, -1, 1}, {0, -1, -1}};
};
Finding prove_closure_a(const ClosureA& claim = {});

/// Case (B): v in BCC_0 but not in SC_0, in halves of the spacing.
struct ClosureB {
  int count = 48;
  Fraction largest_radius_sq{9, 16};
  Shape bounds{kAngle45, kAngle120, {3, 4}};
};
Finding prove_closure_b(const ClosureB& claim = {});

/// Bricks, case (A) at the boundary: the places of v where a parent may be missing.
struct ClosureBrick {
  /// Tetrahedra with their circumcentre beyond a face that v is on, v the middle of an edge in a face of the
  /// brick, of a face there, of an edge in the brick's edge (beyond one of its two faces: three each, and
  /// none beyond both).
  int edge_in_a_face = 6, face_in_a_face = 0, edge_in_an_edge = 6;
  Shape beyond{kAngle45, kAngle90, {13, 16}};
  Shape bounds{kAngle30, kAngle135, {5, 4}};
  bool keep_parents_of_parents_out = true;
};
Finding prove_closure_brick(const ClosureBrick& claim = {});

/// The paper's conclusion: the least angle that is left when one lattice and its double alone are used, that
/// is of the tetrahedra of L_0 whose circumballs hold no point of L_1.
struct SingleLattices {
  /// In degrees times 1000, as printed.
  int sc = 17023, bcc = 14312, fcc = 14197;
};
Finding prove_single_lattices(const SingleLattices& claim = {});

}  // namespace unsliver::prover
