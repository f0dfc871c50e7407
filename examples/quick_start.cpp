// A ball with a size that varies: mesh it, look at its quality, write it for ParaView.
#include <cstdio>

#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"
#include "unsliver/io.hpp"
#include "unsliver/quality.hpp"
#include "unsliver/refine.hpp"
#include "unsliver/sizing.hpp"

int main() try {
  const unsliver::DomainPtr ball = unsliver::make_ball({0, 0, 0}, 1);
  const unsliver::SizingPtr size = unsliver::expression_size("0.08 + 0.1 * abs(z)", ball->bounds());
  const unsliver::MeshResult result = unsliver::mesh_domain(*ball, *size);

  const unsliver::QualitySummary quality = unsliver::summarize_quality(result.mesh);
  std::printf("%zu tetrahedra, dihedral angles from %.1f to %.1f degrees\n", quality.tets,
              quality.min_dihedral_deg, quality.max_dihedral_deg);
  unsliver::io::write_tet_mesh("quick_start.vtu", result.mesh);
  return quality.outside_30_135 == 0 ? 0 : 1;
} catch (const unsliver::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
