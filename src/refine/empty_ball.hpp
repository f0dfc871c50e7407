/// \file
/// The search behind size enforcement: "does a point p of the domain exist such that a closed ball of radius
/// s(p) centred at p is empty?"
///
/// Looking at circumcentres alone would be wrong (they can lie outside the domain), so each tetrahedron is
/// searched by branch and bound. Notation, for one tetrahedron t: c the circumcentre, R the circumradius, L
/// the Lipschitz constant of s; a cell is a box that may hold such a p in t.
#pragma once

#include <optional>
#include <vector>

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// A point p of the domain whose ball of radius (1 - kSizeSlack) s(p) is empty, or nearly so (see probe).
struct EmptyBall {
  Vec3 center;  ///< p, an integer point, in the domain or within kWitnessSlack s of it
  double size;  ///< s(p)
};

class EmptyBallSearch {
 public:
  explicit EmptyBallSearch(Refinement& refinement) : r_(refinement) {}

  /// An empty ball of the sizing function max(s, floor) about a point of t. Sound: nothing is returned only
  /// if every p of t in the domain has a vertex within max(s(p), floor).
  std::optional<EmptyBall> find(TetId t, double floor);

  /// Only t's circumball is looked at: what it finds is an empty ball, what it does not find proves nothing.
  std::optional<EmptyBall> find_quickly(TetId t, double floor);

  /// The lattice point that a size insertion takes: within r(level) of p. Literal: the first point found of
  /// SC_j, j the largest with r(SC_j) <= s(p). Thrifty: the nearest point of the coarsest level, SC or BCC,
  /// that fits. \throws Error kLimit when no usable level is that fine.
  struct LatticePoint {
    Vec3 w;
    Level level;
  };
  LatticePoint point_for(const EmptyBall& ball) const;

 private:
  struct Cell {
    Vec3 center, half;
    bool inside;  ///< known to lie in the domain
  };

  /// Squared distances from p to the nearest and the farthest point of a cell.
  static double nearest_sq(const Cell& cell, const Vec3& p);
  static double farthest_sq(const Cell& cell, const Vec3& p);

  bool circumsphere_covers(TetId t);
  std::optional<EmptyBall> try_circumcenter() const;
  std::optional<EmptyBall> branch_and_bound(TetId t);
  void aim_at(TetId t);
  bool misses_tet(const Cell& cell) const;
  bool covered(const Cell& cell, double size) const;
  double size_lower_bound(const Cell& cell, std::optional<double> center_size) const;
  std::optional<EmptyBall> probe(const Cell& cell, double size, TetId t);
  std::optional<EmptyBall> insert_rather_than_prove(const EmptyBall& ball, TetId t);
  void split(const Cell& cell);
  double nearest_listed_sq(const Vec3& q) const;

  Refinement& r_;
  double floor_ = 0;
  bool open_question_ = false;         ///< t's circumball did not settle whether t is covered
  geom::Sphere sphere_;                ///< c and R^2
  std::optional<double> center_size_;  ///< s(c)
  double reach_ = 0;                   ///< farther than this from c all of t is covered
  int center_side_ = 0;                ///< of the ball of radius reach_ about c, see Domain::side_of_ball
  Vec3 inward_[4];                     ///< unit normals of t's facets
  double offset_[4];                   ///< p is in t where inward . p >= offset for all four
  std::vector<Cell> open_;
  std::vector<Vec3> vertices_;  ///< t's corners and other vertices found nearby
};

}  // namespace unsliver::refine
