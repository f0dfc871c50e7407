/// \file
/// Vertices that come or go among those of a forest, by the leaves whose tetrahedra may give way to them.
#pragma once

#include <span>
#include <vector>

#include "octree/forest.hpp"

namespace unsliver::refine {

/// A vertex, and the group that it is with in one place.
struct Disturber {
  Vec3 place;
  VertexId group;
};

class Disturbers {
 public:
  /// Sets octree::kDisturbed in all leaves that may own tetrahedra with such a corner, or in conflict with
  /// one, and in the parents of these leaves.
  Disturbers(octree::Forest& forest, std::vector<Disturber> disturbers);

  /// Those that may touch the tetrahedra of a leaf.
  std::span<const Vec3> at(octree::NodeId leaf) const;

 private:
  /// places_[first .. first + count)
  struct Run {
    octree::NodeId leaf;
    std::uint32_t first, count;
  };
  void visit_group(octree::Forest& forest, std::span<const Disturber> group);
  void join_runs();

  std::vector<Run> runs_;  ///< by leaf
  std::vector<Vec3> places_;
};

}  // namespace unsliver::refine
