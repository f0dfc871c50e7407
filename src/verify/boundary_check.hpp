/// \file
/// The boundary of the mesh as a surface.
#pragma once

#include <vector>

#include "verify/context.hpp"
#include "verify/facet.hpp"

namespace unsliver::verifier {

/// Findings "boundary" for edges where the oriented boundary facets do not cancel: a hole. Pinched edges and
/// the Euler characteristic are a line of the report: a union of tetrahedra may touch itself.
void check_boundary(const Context& context, const std::vector<Facet>& facets);

}  // namespace unsliver::verifier
