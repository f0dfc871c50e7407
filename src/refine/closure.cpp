#include "refine/closure.hpp"

#include <cassert>

#include "lattice/parents.hpp"
#include "refine/guarantees.hpp"
#include "refine/size_enforcement.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

/// In spacings of SC_45. A ball that meets the domain, which stays within 0.51 spacings of the origin, and
/// holds no point of SC_45 within 3 spacings has a radius of at most 0.87 spacings. So the corners of
/// tetrahedra that meet the domain lie within 2.3 spacings, and as parents of points not in SC_45 are at most
/// half a spacing away along each axis, those of their corners within 2.8.
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
    if (made_.empty())
      throw Error(
          ErrorCode::kInternal,
          "an empty ball holds the point to be inserted: this is a bug in unsliver, please report it");
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
