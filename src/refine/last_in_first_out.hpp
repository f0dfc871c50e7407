/// \file
/// The order of the thrifty strategies: tetrahedra in storage order, what one makes right behind it.
#pragma once

#include <vector>

#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

/// Calls work(t, pending) for every slot of the kernel, alive or not, and for what work() has put behind
/// `pending`, the last first.
template <class R, class Work>
void last_in_first_out(const R& r, const Work& work) {
  std::vector<TetId> pending;
  const std::size_t slots = r.mesh().slot_count();
  for (TetId first = 0; first < slots; ++first) {
    r.mesh().prefetch_ahead(first);
    for (pending.assign(1, first); !pending.empty();) {
      const TetId t = pending.back();
      pending.pop_back();
      work(t, pending);
    }
  }
}

}  // namespace unsliver::refine
