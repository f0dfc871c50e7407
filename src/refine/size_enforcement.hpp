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

  /// An empty ball of the sizing function max(s, floor) about a point of t, if there is one. Sound: nothing
  /// is returned only if every p of t in the domain has a vertex within max(s(p), floor).
  std::optional<EmptyBall> find_empty_ball(TetId t, double floor);

 private:
  using Cell = Tet;
  enum class Verdict { kCovered, kOpen };

  bool surely_covered(TetId t, double floor);
  Verdict judge(const Cell& cell, double floor) const;
  std::optional<EmptyBall> probe(const Cell& cell, double floor, TetId t);
  std::optional<EmptyBall> try_center(const Vec3& p, double floor, TetId t);
  void list_vertex(VertexId v);

  struct Listed {
    Vec3 position;
    double size;  ///< s there, negative when not defined
  };

  Refinement& r_;
  std::vector<Cell> open_;
  std::vector<Listed> vertices_;  ///< t's corners and other vertices found nearby
};

/// Thrifty: inserts until every ball B(p, s(p)), p in the domain, holds a vertex. Works through sizes max(s,
/// 2^i floor), i falling, so that points come in rounds of growing density; each round walks the tetrahedra
/// in storage order and finishes each neighbourhood before it moves on. Inserts from the coarsest level, SC
/// or BCC, that fits.
void enforce_size(Refinement& refinement);

/// The paper's choice: a point of SC_j within r(SC_j) of p, j the largest with r(SC_j) <= s(p).
/// `first_found` takes the lexicographically first point of SC_j in the ball, else the nearest of the
/// coarsest level that fits.
void insert_for_size(Refinement& refinement, const EmptyBall& ball, TetId near, Strategy strategy);

}  // namespace unsliver::refine
