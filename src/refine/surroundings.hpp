/// \file
/// What a forest has around input vertices, gathered before anything is refined.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "refine/bulk_points.hpp"
#include "refine/inputs.hpp"

namespace unsliver::refine {

/// A vertex of the forest near an input vertex.
struct BulkVertex {
  Vec3 place;     ///< world
  int exponent;   ///< of the smallest leaf there
  VertexId home;  ///< the input vertex, by its site
};

struct Surroundings {
  /// Of one input vertex u.
  struct Site {
    double radius;        ///< all vertices of the forest within this of u are in `kept` or `removed`
    double shell_radius;  ///< all that are within this, but not within `radius`, are in its shell
    std::size_t shell_first, shell_size;
  };
  std::span<const Vec3> shell(const Site& site) const {
    return {shells.data() + site.shell_first, site.shell_size};
  }

  std::vector<BulkVertex> kept;     ///< neighbours follow each other
  std::vector<BulkVertex> removed;  ///< an input vertex is in their region, see finest_label
  std::vector<Site> sites;
  double least_radius = std::numeric_limits<double>::infinity();  ///< of all sites
  std::vector<Vec3> shells;
};

/// Labels of the forest's vertices are this or coarser, SC_{k-2} where the world has it, k the exponent of
/// the smallest leaf there: the smaller the region, the fewer vertices are removed and must be made up for,
/// but the more slivers remain between them and the input vertices. (SC_{k-1} takes twice, SC_{k-3} 1.6 times
/// the vertices.)
lattice::Level finest_label(int leaf_exponent, lattice::Level finest_of_world);

/// Sets octree::kVisited in all leaves that have a vertex among `kept` and `removed`, and, of those not
/// kOutside, in all that have one whose region with label BCC_k, k the leaf's exponent, holds an input
/// vertex. Requires that no input vertex is beyond the forest.
Surroundings gather_surroundings(octree::Forest& forest, const Inputs& inputs,
                                 lattice::Level finest_of_world);

}  // namespace unsliver::refine
