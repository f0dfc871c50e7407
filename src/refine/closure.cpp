#include "refine/closure.hpp"

#include <cassert>

#include "lattice/parents.hpp"
#include "refine/guarantees.hpp"
#include "refine/size_enforcement.hpp"

namespace unsliver::refine {

namespace {

/// In spacings of SC_45. All that matters lies within: a tetrahedron that meets the domain has, unless all
/// its corners are of SC_45, a finest spacing of at most 2^44 and R <= sqrt(5)/2 times that. So its corners
/// lie within 3.3 * 2^44 of the origin, and its finest corner's parents within 4.3 * 2^44. (The domain itself
/// stays within 2^44 (1 + 2^-4); see World::fit.)
constexpr int kTopReach = 3;
constexpr double kFarthest = kTopReach * 0x1p45;

class Closure {
 public:
  explicit Closure(Refinement& r) : r_(r) {}

  void insert_top() {
    for (int i = -kTopReach; i <= kTopReach; ++i)
      for (int j = -kTopReach; j <= kTopReach; ++j)
        for (int k = -kTopReach; k <= kTopReach; ++k)
          insert(0x1p45 * Vec3{double(i), double(j), double(k)}, 0);
  }

  /// The coarsest level that fits, and what parents of it are missing.
  std::span<const TetId> insert_for_size(const EmptyBallSearch& search, const EmptyBall& ball) {
    made_.clear();
    const Vec3 w = search.point_for(ball).w;
    insert(w, kClosureC * ball.size + dist(w, ball.center));
    ++r_.stats().size_insertions;
    return made_.span();
  }

 private:
  void insert(const Vec3& w, double lfs_bound) {
    const TetId t = r_.mesh().locate(w);
    if (r_.mesh().corner_at(t, w) != kNoVertex) return;
    const Level level = lattice::canonical_level(w);
    assert(level >= kTopLevel || lfs_bound <= closure_budget(level) * (1 + 1e-6));
    r_.insert_in_conflict(w, level, lfs_bound, t);
    for (const TetId made : r_.created()) made_.push_back(made);
    if (level >= kTopLevel) return;
    for (const Vec3& parent : lattice::Parents(w))
      if (is_near(parent)) insert(parent, lfs_bound + dist(w, parent));
  }

  static bool is_near(const Vec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest;
  }

  Refinement& r_;
  PodVector<TetId> made_;
};

}  // namespace

void closure(Refinement& r) {
  r.enter_phase("size");
  Closure closure(r);
  closure.insert_top();
  enforce_size(r, [&](const EmptyBallSearch& search, const EmptyBall& ball, TetId) {
    return closure.insert_for_size(search, ball);
  });
}

}  // namespace unsliver::refine
