/// \file
/// One facet: the order of its corners, and its name.
#pragma once

#include <array>
#include <string>

#include "unsliver/types.hpp"

namespace unsliver::verifier {

/// Counter-clockwise seen from outside of a positive tetrahedron.
using Facet = std::array<VertexId, 3>;

/// Corners of the face opposite to corner i.
inline constexpr std::array<std::array<int, 3>, 4> kFace{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The face opposite to corner i, its smallest vertex first.
inline Facet face_from_smallest(const std::array<VertexId, 4>& tet, int i) {
  const VertexId a = tet[kFace[i][0]], b = tet[kFace[i][1]], c = tet[kFace[i][2]];
  if (a < b && a < c) return {a, b, c};
  return b < c ? Facet{b, c, a} : Facet{c, a, b};
}

inline std::string name_of(const Facet& f) {
  return "facet " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]);
}

}  // namespace unsliver::verifier
