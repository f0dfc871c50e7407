/// \file
/// A forest over a domain, as fine as the size asks for.
#pragma once

#include <functional>

#include "octree/leaf_test.hpp"

namespace unsliver::octree {

/// A box of the caller's, in world units, not rounded.
Box3 in_world(const Box3& box, const lattice::World& world);

/// Cubes at least as large as the box, aligned to their own lattice, that cover the box (world units) and one
/// more layer around it.
Brick brick_around(const Box3& box);

struct GrowthSettings {
  unsigned threads = 1;
  bool all_centers = false;
  std::uint8_t root_flags = 0;  ///< what is known of all roots
  /// Called now and then from the calling thread, with the bytes held so far (about); may throw.
  std::function<void(std::uint64_t)> poll;
};

/// Splits leaves until LeafTest accepts each, and sets the flags of all nodes; not balanced. The result does
/// not depend on the number of threads. \throws Error kLimit where leaves would be finer than the world
/// allows, and what the sizing function throws.
LeafTestCounts grow(Forest& forest, const LeafTest& test, const GrowthSettings& settings);

}  // namespace unsliver::octree
