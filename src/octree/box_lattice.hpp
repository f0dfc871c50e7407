/// \file
/// Which lattices fill a box exactly: cubes that stack up to it, with all corners exact doubles.
///
/// The root cubes' side is g = d * 2^e, d an odd number below 128 (World's mantissas), and each of the box's
/// sides is a multiple of g. The world's origin is the box's lower corner, so the roots are aligned, and that
/// corner must be a multiple of d * 2^(e - 44) or so.
#pragma once

#include <vector>

#include "lattice/world.hpp"
#include "octree/forest.hpp"

namespace unsliver::octree {

/// More roots than this cost more memory than their tetrahedra.
inline constexpr double kMostRoots = 0x1p20;

struct BoxLattice {
  lattice::World world;
  Brick brick;  ///< world units; its corners are exactly those of the box
};

/// One for each d that fits, with the largest e; the largest roots first. Not empty. Requires positive sides.
/// \throws Error kUnsupported where no cubes fill the box, with a box near it that some do fill (or a
/// remedy) in the message, kLimit where it takes more than kMostRoots of them. places = that box.
std::vector<BoxLattice> lattices_of(const Box3& box);

}  // namespace unsliver::octree
