/// \file
/// Which unit suits a size: leaves come in sides of unit * 2^k, and rounding s down to them costs vertices.
#pragma once

#include "octree/box_lattice.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::octree {

/// The radius for lattice::World::fit. For constant s it costs no rounding at all; else the one of a dozen in
/// an octave that needs the fewest vertices, judged by the leaves at some sample points. 0 if the least size
/// is not known. Here and below, the result does not depend on the number of threads.
double fit_radius(const Domain& domain, const Sizing& sizing, unsigned threads = 1);

/// Of the lattices that fill a box (at least one), that which needs the fewest vertices, judged likewise; the
/// first of those that need equally many.
const BoxLattice& fit_lattice(const std::vector<BoxLattice>& lattices, const Domain& box,
                              const Sizing& sizing, unsigned threads = 1);

}  // namespace unsliver::octree
