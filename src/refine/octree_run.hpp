/// \file
/// A run of the octree mesher in terms of the library's options and results.
#pragma once

#include "octree/octree.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::refine {

octree::OctreeOptions octree_options(const MeshOptions& options);

/// Without limits and strategy.
MeshResult result_of(octree::OctreeResult&& made, const octree::OctreeOptions& limits);

}  // namespace unsliver::refine
