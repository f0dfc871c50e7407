#include <cstdio>

#include "unsliver/domain.hpp"
#include "unsliver/quality.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/sizing.hpp"

int main() {
  const auto ball = unsliver::make_ball({0, 0, 0}, 1);
  const auto size = unsliver::constant_size(0.25);
  const unsliver::MeshResult result = unsliver::mesh_domain(*ball, *size);
  const unsliver::QualitySummary quality = unsliver::summarize_quality(result.mesh);
  std::printf("%zu tetrahedra, dihedral angles %.3f to %.3f degrees\n", quality.tets,
              quality.min_dihedral_deg, quality.max_dihedral_deg);
  return quality.tets > 0 && quality.outside_30_135 == 0 ? 0 : 1;
}
