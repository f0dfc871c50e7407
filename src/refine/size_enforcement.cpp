#include "refine/size_enforcement.hpp"

#include "refine/guarantees.hpp"

namespace unsliver::refine {

void insert_for_size(Refinement& r, const EmptyBallSearch& search, const EmptyBall& ball, TetId near) {
  const auto [w, level] = search.point_for(ball);
  const bool literal = r.strategy() == Strategy::kLiteral;
  const double c = literal ? kFigure5LiteralC : kFigure5ThriftyC;
  const Level label = literal ? level : lattice::canonical_level(w);
  r.insert(w, label, c * ball.size + dist(w, ball.center), near);
  ++r.stats().size_insertions;
}

namespace {

template <class FindEmptyBall>
void sweep(Refinement& r, const EmptyBallSearch& search, FindEmptyBall find) {
  std::vector<TetId> pending;
  const std::size_t slots = r.mesh().slot_count();
  for (TetId first = 0; first < slots; ++first)
    for (pending.assign(1, first); !pending.empty();) {
      const TetId t = pending.back();
      pending.pop_back();
      if (!r.mesh().is_finite(t)) continue;
      const auto ball = find(t);
      if (!ball) continue;
      pending.push_back(t);  // it may survive: w can lie outside its circumsphere
      insert_for_size(r, search, *ball, t);
      pending.insert(pending.end(), r.created().begin(), r.created().end());
    }
}

/// The long searches come second, when only the tetrahedra that will stay are left to search.
void sweep_twice(Refinement& r, EmptyBallSearch& search, double floor) {
  sweep(r, search, [&](TetId t) { return search.find_quickly(t, floor); });
  sweep(r, search, [&](TetId t) { return search.find(t, floor); });
}

}  // namespace

void enforce_size(Refinement& r) {
  EmptyBallSearch search(r);
  double floor = r.smallest_size();
  while (floor < r.largest_size()) floor *= 2;
  for (; floor > r.smallest_size(); floor /= 2) sweep_twice(r, search, floor);
  sweep_twice(r, search, 0);
}

}  // namespace unsliver::refine
