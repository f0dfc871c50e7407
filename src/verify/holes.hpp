/// \file
/// Does the domain go on where the mesh ends?
#pragma once

#include "verify/facet.hpp"
#include "verify/report.hpp"

namespace unsliver::verifier {

/// Four points outside the facet, off it by a millionth of an edge or so: the domain may end in the facet
/// itself. Not finite where the facet is flat.
std::array<Vec3, 4> points_beyond(const std::array<Vec3, 3>& corners);

/// Finding "cover": p, beyond the facet, is in the domain and not in the mesh.
void find_hole(Reporter& reporter, const Facet& facet, const Vec3& p);

/// A line on `holes` such findings at `facets` facets.
void report_holes(Reporter& reporter, std::uint64_t facets, std::uint64_t holes);

}  // namespace unsliver::verifier
