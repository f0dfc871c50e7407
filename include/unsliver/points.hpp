/// \file
/// Points that the caller wants as vertices of the mesh.
#pragma once

#include <string>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver {

/// Points in the caller's order and units: the index of a point is its id. Duplicates are kept.
struct PointSet {
  std::vector<Vec3> points;        ///< n, finite
  std::vector<double> sizes;       ///< n or empty: the size wanted at each point, positive and finite
  std::vector<std::string> notes;  ///< what the reader skipped or merged, as sentences for the user
};

}  // namespace unsliver
