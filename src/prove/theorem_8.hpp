/// \file
/// Theorem 8 of the paper: one input vertex p in the cubic lattice, and Table 1.
///
/// Notation: k = 0. R(p, 0) is the cube of half side sigma about p; S = {p} and the points of SC_0 outside of
/// R(p, 0). Along an axis R covers two lattice coordinates, 1 and 2, or three, 1, 2 and 3: with mirrors, p's
/// coordinate is in I = (sigma, 3/2] or J = [3 - sigma, 2]. The hole is the box from 0 to 3 or 4 along each
/// axis; box face vertices are the lattice points in the relative interiors of its faces. Case n = 1..4 has n
/// - 1 axes of the second kind, the last ones.
#pragma once

#include "prove/extremes.hpp"
#include "prove/finding.hpp"

namespace unsliver::prover {

/// 4 sigma = 2 + sqrt(6)
inline const Surd kFourSigma{2, 1};

/// The Delaunay subdivision of S is the same for all p of a case: p joins the convex hull of the box face
/// vertices, which is the union of pyramids over `bases`; all else are lattice cubes, whole or cut off.
struct Theorem8 {
  Surd four_sigma = kFourSigma;
  std::array<int, 4> face_vertices = {24, 32, 42, 54};
};
Finding prove_theorem_8(const Theorem8& claim = {});

/// Table 1 by case, in thousandths of degrees and of the ratio.
struct Table1 {
  std::array<int, 4> least = {31'962, 30'129, 30'000, 34'785};
  std::array<int, 4> greatest = {125'264, 125'264, 127'903, 125'264};
  std::array<int, 4> ratio = {1'198, 1'267, 1'329, 1'368};
  /// The cases whose greatest angle is that of lattice tetrahedra, wherever p is: (*) in the table.
  std::array<bool, 4> greatest_is_intrinsic = {true, true, false, true};
  /// What holds in all cases.
  Fraction least_signed_cos_sq{3, 4};
  int greatest_bound = 127'903, ratio_bound = 1'368;
  Surd four_sigma = kFourSigma;
};
Finding prove_table_1(const Table1& claim = {});

/// One case of Theorem 8.
class Hole {
 public:
  /// `wide` axes of the second kind.
  explicit Hole(int wide);

  /// Side of the box along an axis.
  int side(int axis) const { return sides_[std::size_t(axis)]; }
  /// The closure of the places of p, in quarters.
  Region region(const Surd& four_sigma) const;
  /// The box face vertices, over each unit cube at the box's boundary: the bases of p's pyramids.
  const std::vector<std::vector<Point>>& bases() const { return bases_; }
  /// The corners of lattice cubes in the box that are left, where they span a cell: 6 or 7.
  const std::vector<std::vector<Point>>& cut_cubes() const { return cut_cubes_; }
  std::vector<Point> face_vertices() const;

 private:
  /// How many coordinates of p are at the box's ends; 0 for removed points.
  int ends(const Point& p) const;

  std::array<int, 3> sides_;
  std::vector<std::vector<Point>> bases_, cut_cubes_;
};

}  // namespace unsliver::prover
