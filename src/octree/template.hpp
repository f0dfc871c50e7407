/// \file
/// The tetrahedra that a leaf owns, as a function of its neighbourhood's key.
///
/// A leaf owns the Delaunay tetrahedra whose circumcentres lie in it (half open: its upper faces belong to
/// the neighbours), and at the end of the brick those beyond. Their vertices are at slots of the leaf
/// (docs/CLOSURE.md), so that the vertices at the leaf's slots alone decide them: a template is that small
/// Delaunay problem, solved exactly, ties broken as everywhere in unsliver.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "octree/neighborhood.hpp"

namespace unsliver::octree {

struct Template {
  std::vector<std::array<std::uint8_t, 4>> tets;  ///< slots; positively oriented
  std::vector<std::uint8_t> slots;                ///< those in use, ascending
};

/// The slots that hold a vertex, ascending.
std::vector<std::uint8_t> occupied_slots(Key key);

Template solve_template(Key key);

}  // namespace unsliver::octree
