#include "refine/size_enforcement.hpp"

#include <cassert>

#include "refine/guarantees.hpp"
#include "refine/last_in_first_out.hpp"
#include "refine/periodic_refinement.hpp"
#include "refine/refinement.hpp"

namespace unsliver::refine {

template <class R>
void insert_for_size(R& r, const EmptyBall& ball, TetId near) {
  const auto [w, level] = point_for(r, ball);
  const bool literal = r.strategy() == Strategy::kLiteral;
  const double c = grading_guarantee(r.strategy(), !r.inputs().empty()).c;
  const Level label = literal ? level : r.inputs().coarsest_label(w, level);
  const double lfs_bound = c * ball.size + dist(w, ball.center);
  assert(r.inputs().empty() || lfs_bound <= figure_8_tight_budget(label));
  r.insert(w, label, lfs_bound, near);
  ++r.stats().size_insertions;
}

namespace {

/// The rounds of thrifty size enforcement. What is known of a tetrahedron is kept by slot, until an insertion
/// fills the slot anew: a ball that holds a vertex keeps it.
template <class R>
class Sweeps {
 public:
  Sweeps(R& r, const InsertForSize& insert) : r_(r), insert_(insert), search_(r) {}

  /// One round, for the sizing function max(s, floor). The long searches come second, when only the
  /// tetrahedra that will stay are left to search.
  void round(double floor) {
    known_.clear();
    sweep(Known::kNothing, [&](TetId t) { return search_.find_quickly(t, floor); });
    sweep(Known::kOpen, [&](TetId t) { return search_.find(t, floor); });
  }

 private:
  enum class Known : std::uint8_t { kNothing, kOpen, kCovered };

  /// Visits every tetrahedron of which no more than `least` is known, those made on the way included.
  template <class FindEmptyBall>
  void sweep(Known least, FindEmptyBall find) {
    known_.resize(r_.mesh().slot_count(), Known::kNothing);
    last_in_first_out(r_, [&](TetId t, std::vector<TetId>& pending) {
      if (known_[t] > least || !r_.mesh().is_finite(t)) return;
      if (const auto ball = find(t)) {
        const std::span<const TetId> made = insert_(*ball, t);
        forget(made);
        pending.push_back(t);  // it may survive: w can lie outside its circumsphere
        pending.insert(pending.end(), made.begin(), made.end());
      } else {
        known_[t] = least == Known::kNothing && search_.open_question() ? Known::kOpen : Known::kCovered;
      }
    });
  }

  void forget(std::span<const TetId> made) {
    known_.resize(r_.mesh().slot_count(), Known::kNothing);
    for (const TetId t : made) known_[t] = Known::kNothing;
  }

  R& r_;
  const InsertForSize& insert_;
  EmptyBallSearch<R> search_;
  PodVector<Known> known_;
};

}  // namespace

template <class R>
void enforce_size(R& r, const InsertForSize& insert) {
  Sweeps<R> sweeps(r, insert);
  double floor = r.smallest_size();
  while (floor < r.largest_size()) floor *= 2;
  for (; floor > r.smallest_size(); floor /= 2) sweeps.round(floor);
  sweeps.round(0);
}

template <class R>
void enforce_size(R& r) {
  enforce_size(r, [&r](const EmptyBall& ball, TetId near) {
    insert_for_size(r, ball, near);
    return r.created();
  });
}

template void insert_for_size(Refinement&, const EmptyBall&, TetId);
template void insert_for_size(PeriodicRefinement&, const EmptyBall&, TetId);
template void enforce_size(Refinement&, const InsertForSize&);
template void enforce_size(PeriodicRefinement&, const InsertForSize&);
template void enforce_size(Refinement&);
template void enforce_size(PeriodicRefinement&);

}  // namespace unsliver::refine
