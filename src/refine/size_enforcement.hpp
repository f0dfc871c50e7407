/// \file
/// Size enforcement: "if there exists a point p of the domain such that a closed ball of radius s(p) centred
/// at p is empty".
///
/// Looking at circumcentres alone would be wrong (they can lie outside the domain), so each tetrahedron is
/// searched by branch and bound over the sub-tetrahedra that meet the domain. The property only ever
/// improves: a ball that holds a vertex keeps it.
#pragma once

#include <optional>
#include <vector>

#include "refine/refinement.hpp"

namespace unsliver::refine {

/// A point whose ball of radius (1 - kSizeSlack) size is empty, in the closed tetrahedron that was searched.
struct EmptyBall {
  Vec3 center;  ///< an integer point, in the domain or within kWitnessSlack * size of it
  double size;
};

class SizeEnforcement {
 public:
  explicit SizeEnforcement(Refinement& refinement) : r_(refinement) {}

  /// An empty ball about a point of t, if there is one. Sound: nothing is returned only if every p of t in
  /// the domain has a vertex within s(p).
  std::optional<EmptyBall> find_empty_ball(TetId t);

  /// Inserts a vertex w within r(level) of the ball's centre. Literal: the first point of SC_j found in B, j
  /// the largest with r(SC_j) <= s(p). Thrifty: the nearest point of the coarsest level, SC or BCC, that
  /// fits.
  void insert_for(const EmptyBall& ball, TetId near);

  /// Thrifty: inserts until every ball B(p, max(s(p), floor)), p in the domain, holds a vertex.
  void sweep(double floor);

 private:
  using Cell = Tet;
  enum class Verdict { kCovered, kOpen };
  struct Listed {
    Vec3 position;
    double size;  ///< s there, negative when not defined
  };

  Verdict judge_circumsphere(TetId t);
  std::optional<EmptyBall> try_circumcenter() const;
  Verdict judge(const Cell& cell) const;
  bool covers(const Cell& cell, double nearest, double size) const;
  void split(const Cell& cell);
  std::optional<EmptyBall> probe(const Cell& cell, TetId t);
  std::optional<EmptyBall> try_center(const Vec3& q, double share, TetId t);
  std::optional<EmptyBall> give_up(const Vec3& q, TetId t);
  void list_vertex(VertexId v);
  Level fitting_level(const EmptyBall& ball) const;

  Refinement& r_;
  double floor_ = 0;
  geom::Sphere sphere_;                ///< of the tetrahedron that is searched
  std::optional<double> center_size_;  ///< s at its circumcentre
  double clearance_ = 0;               ///< of its circumcentre
  std::vector<Cell> open_;
  std::vector<Listed> vertices_;  ///< t's corners and other vertices found nearby
};

/// Thrifty size enforcement: sweeps with falling floors, so that points come in rounds of growing density and
/// the tetrahedralization is never far from uniform; each sweep walks the tetrahedra in storage order and
/// finishes each neighbourhood before it moves on.
void enforce_size(Refinement& refinement);

}  // namespace unsliver::refine
