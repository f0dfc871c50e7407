#include "refine/closure.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "lattice/parents.hpp"
#include "refine/guarantees.hpp"
#include "refine/periodic_refinement.hpp"
#include "refine/refinement.hpp"
#include "refine/size_enforcement.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

/// In spacings of SC_45, whose points within three spacings are vertices from the start. A ball that meets
/// the domain, which stays within 0.51 spacings of the origin, and holds no point of SC_45 within 3 spacings
/// has a radius of at most 0.87 spacings. So the corners of tetrahedra that meet the domain lie within 2.3
/// spacings, and as parents of points not in SC_45 are at most half a spacing away along each axis, those of
/// their corners within 2.8.
constexpr double kTopSpacing = 0x1p45;
constexpr double kFarthest = 3 * kTopSpacing;

template <class R>
class Closure {
 public:
  /// Points of level `top` need no parents, and parents farther than `reach` along some axis are not needed.
  Closure(R& r, Level top, double reach) : r_(r), top_(top), reach_(reach) {}

  void insert_all_near(double spacing) {
    for (double x = -reach_; x <= reach_; x += spacing)
      for (double y = -reach_; y <= reach_; y += spacing)
        for (double z = -reach_; z <= reach_; z += spacing) insert({x, y, z}, 0);
  }

  void enforce_size() {
    refine::enforce_size(r_, [this](const EmptyBall& ball, TetId) { return insert_for_size(ball); });
  }

 private:
  /// The coarsest level that fits, and what parents of it are missing.
  std::span<const TetId> insert_for_size(const EmptyBall& ball) {
    made_.clear();
    const Vec3 w = point_for(r_, ball).w;
    insert(w, kClosureC * ball.size + dist(w, ball.center));
    if (made_.empty())
      throw Error(
          ErrorCode::kInternal,
          "an empty ball holds the point to be inserted: this is a bug in unsliver, please report it");
    ++r_.stats().size_insertions;
    return made_.span();
  }

  void insert(const Vec3& w, double lfs_bound) {
    Vec3 seen = w;
    const TetId t = r_.mesh().walk_to(seen);
    if (r_.mesh().corner_at(t, seen) != kNoVertex) return;
    const Level level = std::min(lattice::canonical_level(w), r_.coarsest_level());
    assert(level >= top_ || lfs_bound <= closure_budget(level) * (1 + 1e-6));
    r_.insert_in_conflict(seen, level, lfs_bound, t);
    for (const TetId made : r_.created()) made_.push_back(made);
    if (level >= top_) return;
    for (const Vec3& parent : lattice::Parents(w))
      if (is_near(parent)) insert(parent, lfs_bound + dist(w, parent));
  }

  bool is_near(const Vec3& p) const {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= reach_;
  }

  R& r_;
  Level top_;
  double reach_;
  PodVector<TetId> made_;
};

}  // namespace

void closure(Refinement& r) {
  r.enter_phase("size");
  Closure closure(r, kTopLevel, kFarthest);
  closure.insert_all_near(kTopSpacing);
  closure.enforce_size();
}

void closure(PeriodicRefinement& r) {
  r.enter_phase("size");
  Closure(r, r.coarsest_level(), std::numeric_limits<double>::infinity()).enforce_size();
}

}  // namespace unsliver::refine
