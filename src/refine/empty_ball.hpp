/// \file
/// The search behind size enforcement: "does a point p of the domain exist such that a closed ball of radius
/// s(p) centred at p is empty?"
///
/// Looking at circumcentres alone would be wrong (they can lie outside the domain), so each tetrahedron is
/// searched by branch and bound. Notation, for one tetrahedron t: c the circumcentre, R the circumradius, L
/// the Lipschitz constant of s; a cell is a tetrahedron, part of t, that may hold such a p. Balls are convex:
/// a ball that holds a cell's corners holds the cell. R is Refinement or PeriodicRefinement.
#pragma once

#include <optional>
#include <vector>

#include "geom/tetrahedron.hpp"
#include "refine/circumsphere.hpp"
#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

/// A point p of the domain whose ball of radius (1 - kSizeSlack) s(p) is empty, or nearly so (see probe).
struct EmptyBall {
  Vec3 center;  ///< p, an integer point, in the domain or within kWitnessSlack s of it
  double size;  ///< s(p)
};

/// A point of a level's lattice.
struct LatticePoint {
  Vec3 w;
  Level level;
};

/// The lattice point that a size insertion takes: within r(level) of p. Literal: the first point found of
/// SC_j, j the largest with r(SC_j) <= s(p). Thrifty: the nearest point of the coarsest level, SC or BCC,
/// that fits. Beside input vertices the figure's own step breaks its invariant: then the point's forbidden
/// region must be empty, and the next finer level serves where there is none.
/// \throws Error kLimit when no usable level is that fine.
template <class R>
LatticePoint point_for(const R& refinement, const EmptyBall& ball);

template <class R>
class EmptyBallSearch {
 public:
  explicit EmptyBallSearch(R& refinement) : r_(refinement) {}

  /// An empty ball of the sizing function max(s, floor) about a point of t. Sound: nothing is returned only
  /// if every p of t in the domain has a vertex within max(s(p), floor).
  std::optional<EmptyBall> find(TetId t, double floor);

  /// Only t's circumball is looked at. What it finds is an empty ball; where it finds nothing, the question
  /// for t may stay open.
  std::optional<EmptyBall> find_quickly(TetId t, double floor);
  bool open_question() const { return open_question_; }

 private:
  struct Cell {
    Tet corners;
    bool inside;  ///< known to lie in the domain
  };
  /// The ball about the mean of a cell's corners that holds the cell.
  struct Hull {
    Vec3 center;
    double radius;
  };
  static Hull hull_of(const Tet& corners);

  bool circumsphere_covers(TetId t);
  std::optional<EmptyBall> try_circumcenter() const;
  std::optional<EmptyBall> branch_and_bound(TetId t);
  bool one_vertex_reaches(const Tet& cell, double size) const;
  bool covered(const Tet& cell, const Hull& hull, double size) const;
  int side_of(const Cell& cell, const Hull& hull) const;
  bool beyond_domain_box(const Tet& cell, const Hull& hull) const;
  double size_lower_bound(const Tet& cell, const Hull& hull, std::optional<double> center_size) const;
  std::optional<EmptyBall> probe(const Cell& cell, const Hull& hull, double size, TetId t);
  std::optional<EmptyBall> insert_rather_than_prove(const EmptyBall& ball, TetId t);
  void split(const Cell& cell);
  double nearest_listed_sq(const Vec3& q) const;

  R& r_;
  double floor_ = 0;
  bool open_question_ = false;         ///< t's circumball did not settle whether t is covered
  geom::Sphere sphere_;                ///< c and R^2
  std::optional<double> center_size_;  ///< s(c)
  double reach_ = 0;                   ///< farther than this from c all of t is covered
  int center_side_ = 0;                ///< of the ball of radius reach_ about c, see Domain::side_of_ball
  std::array<Vec3, 4> corners_;        ///< t's
  std::array<double, 4> clearances_;   ///< theirs, see Domain::clearance
  std::vector<Cell> open_;
  std::vector<Vec3> vertices_;  ///< t's corners and other vertices found nearby
};

}  // namespace unsliver::refine
