/// \file
/// A forest cut into parts for threads to share, and what a part needs to know of its neighbours.
#pragma once

#include <vector>

#include "octree/block.hpp"

namespace unsliver::octree {

/// A node with all that is below it, or alone.
struct Part {
  Cell cell;
  bool whole;
};

/// All nodes, depth first: whole parts of at most 1 in `count` of the nodes, or so few that no thread is
/// worth it, and between them the nodes above, alone. Lists of what is found in each, one behind the other,
/// are the same for each `count`.
std::vector<Part> cut(const Forest& forest, std::size_t count);

/// A node seen from the block of its parent's children, or of the roots.
struct Site {
  Block block;
  int place;
};

Site site_of(const Forest& forest, const Cell& cell);

}  // namespace unsliver::octree
