#include <numeric>

#include "verify/holders.hpp"
#include "verify/holes.hpp"
#include "verify/sampling_checks.hpp"

namespace unsliver::verifier {
namespace {

/// Points of the domain just beyond facets that the mesh ends at, where it touches itself perhaps.
struct Suspects {
  std::vector<Vec3> points;
  std::vector<std::size_t> facets;  ///< ascending
};

Suspects find_suspects(const Context& c, const std::vector<Facet>& boundary) {
  Suspects suspects;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    c.pulse.beats(0);
    const auto& [u, v, w] = boundary[i];
    for (const Vec3& p : points_beyond({c.mesh.points[u], c.mesh.points[v], c.mesh.points[w]})) {
      if (!is_finite(p) || !c.options.inside(p)) continue;
      suspects.points.push_back(p);
      suspects.facets.push_back(i);
    }
  }
  return suspects;
}

}  // namespace

void check_holes(const Context& c, const std::vector<Facet>& boundary) {
  const Suspects suspects = find_suspects(c, boundary);
  std::vector<VertexId> ids(suspects.points.size());
  std::iota(ids.begin(), ids.end(), VertexId{0});
  std::size_t last = boundary.size();
  for (const VertexId id : uncovered(c, suspects.points, ids))
    if (const std::size_t facet = suspects.facets[id]; std::exchange(last, facet) != facet)
      find_hole(c.reporter, boundary[facet], suspects.points[id]);
  report_holes(c.reporter, boundary.size(), c.reporter.count("cover"));
}

}  // namespace unsliver::verifier
