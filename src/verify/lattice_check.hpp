/// \file
/// Are the vertices where their levels say, exactly?
#pragma once

#include "verify/context.hpp"
#include "verify/sites.hpp"

namespace unsliver::verifier {

/// Is q in the lattice of a level > 0: odd 2k + 1 = SC_k, the multiples of 2^k; even 2k = BCC_k, SC_k and the
/// centres of its cells?
bool in_lattice(int level, const Row<std::int64_t>& q);

/// Findings "lattice": a vertex of level > 0 off the grid of the frame, or on it but outside its lattice.
/// Requires: frame and levels.
void check_lattice(const Context& context, const FramePlaces& places);

/// May the mesh be judged at the places' integers: is every vertex there, input vertices aside?
bool judged_on_frame(const TetMesh& mesh, const FramePlaces& places);

}  // namespace unsliver::verifier
