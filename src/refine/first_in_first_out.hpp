/// \file
/// The order of the literal strategy: "repeat the enforcement steps below until none apply", first in first
/// out, size before quality.
#pragma once

#include <deque>

#include "refine/queued.hpp"
#include "refine/size_enforcement.hpp"

namespace unsliver::refine {

/// What waited for long is in no cache: asks for it in good time.
template <class R>
void prefetch(const R& r, const std::deque<Queued>& queue) {
  constexpr std::size_t kRecord = 32, kCorners = 16;
  if (queue.size() <= kRecord) return;
  r.mesh().prefetch(queue[kRecord].slot);
  if (still_there(r, queue[kCorners])) r.prefetch_corners(queue[kCorners].slot);
}

/// `enforce_quality(t)` inserts a vertex for the bad tetrahedron t.
template <class R, class EnforceQuality>
void first_in_first_out(R& r, EnforceQuality enforce_quality) {
  r.enter_phase("refine");
  EmptyBallSearch<R> search(r);
  std::deque<Queued> queue;
  for (TetId t = 0; t < r.mesh().slot_count(); ++t) queue.push_back(queued(r, t));
  for (; !queue.empty(); queue.pop_front()) {
    prefetch(r, queue);
    const TetId t = queue.front().slot;
    if (!still_there(r, queue.front())) continue;
    if (const auto ball = search.find(t, 0)) {
      queue.push_back(queue.front());  // t may survive: w can lie outside its circumsphere
      insert_for_size(r, *ball, t);
    } else if (r.is_bad(t) && r.meets_domain(t)) {
      enforce_quality(t);
    } else {
      continue;
    }
    for (TetId made : r.created()) queue.push_back(queued(r, made));
  }
}

}  // namespace unsliver::refine
