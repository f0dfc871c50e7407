/// \file
/// Balance across faces and edges, and the centres that it needs.
#pragma once

#include <cstdint>
#include <functional>

#include "octree/forest.hpp"

namespace unsliver::octree {

/// Splits leaves until leaves that share a face or part of an edge differ by at most a factor of 2 in side,
/// and sets kHasCenter for every leaf with a hanging vertex. Then, and only then, do the corners and centres
/// hold the parents of each of them (docs/CLOSURE.md). `on_split(cell)` is called for each leaf that was
/// split, from the calling thread, to set the flags of its children. Sets kUniform. Returns the number of
/// splits. The forest does not depend on the number of threads.
std::uint64_t balance(Forest& forest, const std::function<void(const Cell&)>& on_split, unsigned threads = 1);

}  // namespace unsliver::octree
