/// \file
/// One pass over the tetrahedra: orientation, quality, local Delaunay property, volume, extremes.
#pragma once

#include <vector>

#include "verify/context.hpp"
#include "verify/sites.hpp"

namespace unsliver::verifier {

/// Findings "orientation", "dihedral", "radius-edge" and "delaunay"; fills the achieved extremes, the volume
/// and the decision counts. `beyond`: see Facets; empty = no Delaunay check.
void check_tetrahedra(const Context& context, const Sites& sites, const std::vector<VertexId>& beyond);

}  // namespace unsliver::verifier
