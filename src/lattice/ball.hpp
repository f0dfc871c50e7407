/// \file
/// All lattice points in a closed ball: the candidates w of Figures 5 and 8.
#pragma once

#include <vector>

#include "lattice/level.hpp"

namespace unsliver::lattice {

/// Appends every point of the level's lattice within `radius` of `center` (real numbers), in lexicographic
/// order. The test is made with a relative slack of 1e-9 towards inclusion: callers decide exactly
/// afterwards. Cost is proportional to the number of lattice points in the ball's bounding box.
void points_in_ball(Level level, const Vec3& center, double radius, std::vector<Vec3>& out);

}  // namespace unsliver::lattice
