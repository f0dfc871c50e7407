/// \file
/// Octrees leaf by leaf: all neighbourhoods at once, and all ties.
///
/// Notation: a leaf is the cube [0, 4]^3. A vertex on a sphere whose centre is in the leaf and that holds no
/// vertex inside is at one of the slots (docs/CLOSURE.md, Lemma 2). A key says which slots are vertices. For
/// four slots and their sphere "is there a key with these vertices and none inside?" is a question about each
/// edge and each face; so 57 choose 4 questions take the place of all keys times all tetrahedra.
#pragma once

#include <set>

#include "prove/finding.hpp"

namespace unsliver::prover {

/// What can be around a leaf.
struct CellRules {
  /// Leaves may have their centre as a vertex: then each leaf with a hanging vertex has it.
  bool has_centers = true;
  /// Other leaves may do without; else all have it.
  bool centers_are_optional = true;
  /// Middles of edges may hang alone, by a split neighbour at the edge; else only with those of a face.
  bool has_edge_neighbors = true;
  /// The forest may end at faces; circumcentres may be beyond these.
  bool may_end = false;
};

/// All tetrahedra that some key gives to the leaf, in all ties, each with its corners in lexicographic order.
std::set<Tetrahedron> cell_tetrahedra(const CellRules& rules);

/// Parent closure in octrees: docs/CLOSURE.md, Octrees.
struct OctreeKeys {
  std::int64_t interior_keys = 319'225, boundary_keys = 3'078'285;
  Shape bounds{kAngle30, kAngle135, {5, 4}};
  bool has_centers = true;
};
Finding prove_octree_keys(const OctreeKeys& claim = {});

/// Section 4: corners of leaves alone.
struct BalancedOctree {
  std::int64_t all_types = 6210;
  /// What the paper states, in thousandths.
  int face_least = 19'471, face_ratio = 1'347;
  Angle face_greatest = kAngle135;
  int all_least = 17'024, all_greatest = 148'518;
  Fraction all_ratio_sq{9, 4};
  /// The fewest vertices of a type with an angle outside [30, 135].
  int smallest_bad = 9;
};
Finding prove_balanced_octree(const BalancedOctree& claim = {});

}  // namespace unsliver::prover
