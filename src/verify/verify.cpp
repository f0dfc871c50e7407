#include "unsliver/verify.hpp"

#include "verify/boundary_check.hpp"
#include "verify/context.hpp"
#include "verify/delaunay_global.hpp"
#include "verify/facets.hpp"
#include "verify/lattice_check.hpp"
#include "verify/periodic_check.hpp"
#include "verify/rounding_check.hpp"
#include "verify/sampling_checks.hpp"
#include "verify/sites.hpp"
#include "verify/structure.hpp"
#include "verify/tetrahedra_check.hpp"
#include "verify/until_cancelled.hpp"

namespace unsliver {
namespace verifier {
namespace {

/// Beats of the whole run: filling twice, matching, judging, and the checks that were asked for.
std::uint64_t expected_beats(const TetMesh& mesh, const VerifyOptions& o) {
  const std::uint64_t m = mesh.tets.size(), n = mesh.points.size();
  const bool facets = o.conforming_superset || o.delaunay;
  return m + (facets ? 2 * m + n : 0) + (o.must_cover.empty() ? 0 : m) + (o.lfs_lower_bound ? n : 0) +
         (o.delaunay_global ? m : 0);
}

bool asks_size(const VerifyOptions& o) { return o.size && o.inside; }

/// Facets matched, their findings made, their halves freed.
std::vector<VertexId> check_facets(const Context& c) {
  if (!c.options.conforming_superset && !c.options.delaunay) return {};
  Reporter* reporter = c.options.conforming_superset ? &c.reporter : nullptr;
  Facets facets = match_facets(c.mesh, reporter, c.pulse);
  if (c.options.conforming_superset) {
    const std::uint64_t wrong = c.reporter.count("conformity");
    c.reporter.line("conformity: " + grouped(facets.interior) + " facets in two tetrahedra, " +
                    grouped(facets.boundary.size()) + " in one" +
                    (wrong == 0 ? "" : "; " + grouped(wrong) + " defects"));
    check_boundary(c, facets.boundary);
    if (c.options.inside && !c.mesh.periodicity) check_holes(c, facets.boundary);
  }
  return c.options.delaunay ? std::move(facets.beyond) : std::vector<VertexId>{};
}

void find_unframed(const Context& c) {
  c.reporter.find("periodic", {}, [] {
    return std::string("a periodic mesh needs a frame that its points fit: whether it closes is not decided");
  });
}

/// The lattice check, and where the judge sees the vertices from then on. Of periodic meshes whether they
/// close.
Sites check_sites(const Context& c) {
  const bool is_periodic = c.mesh.periodicity.has_value();
  if (is_periodic && !c.mesh.frame) find_unframed(c);
  if (!c.mesh.frame) return Sites(c.mesh.points);
  FramePlaces places = place_on_frame(c.mesh);
  if (!c.mesh.levels.empty()) check_lattice(c, places);
  const bool is_framed = judged_on_frame(c.mesh, places);
  if (is_periodic && !is_framed) find_unframed(c);
  if (!is_framed) return Sites(c.mesh.points);
  check_rounding(c, places);
  if (is_periodic && align_copies(c, places)) check_torus(c, places.q);
  return Sites(std::move(places.q), c.mesh.frame->unit);
}

/// The Delaunay property is check_torus's.
void check_with_tree_of_copies(const Context& c, const std::vector<VertexId>& used) {
  if (c.reporter.count("periodic") > 0) return;
  const CopiesAround around = copies_around(c.mesh, used);
  const KdTree vertices(around.points, around.ids);
  if (asks_size(c.options)) check_size(c, vertices, used);
  if (c.options.lfs_lower_bound) check_grading(c, vertices, around.homes);
}

void check_with_tree(const Context& c, const Sites& sites, const std::vector<VertexId>& used) {
  const VerifyOptions& o = c.options;
  if (!asks_size(o) && !o.lfs_lower_bound && !o.delaunay_global) return;
  if (c.mesh.periodicity) return check_with_tree_of_copies(c, used);
  const KdTree vertices(c.mesh.points, used);
  if (asks_size(o)) check_size(c, vertices, used);
  if (o.lfs_lower_bound) check_grading(c, vertices, used);
  if (o.delaunay_global) check_delaunay_globally(c, sites, vertices);
}

void run(const Context& c) {
  if (!check_structure(c)) return;
  const std::vector<VertexId> used = used_vertices(c.mesh);
  if (c.options.conforming_superset) check_coincident(c, used);
  const std::vector<VertexId> beyond = check_facets(c);
  const Sites sites = check_sites(c);
  check_tetrahedra(c, sites, beyond);
  check_with_tree(c, sites, used);
  if (!c.options.must_cover.empty()) check_cover(c);
  const VerifyReport& r = c.reporter.report();
  c.reporter.line("decisions: " + grouped(r.filtered_decisions) + " in doubles where they cannot err, " +
                  grouped(r.exact_decisions) + " in integers");
}

}  // namespace
}  // namespace verifier

VerifyReport verify(const TetMesh& mesh, const VerifyOptions& options, const Control& control) {
  using namespace verifier;
  VerifyReport report;
  Reporter reporter(report, options.max_findings);
  Pulse pulse(control, expected_beats(mesh, options), mesh.points.size(), mesh.tets.size());
  run_until_cancelled(reporter, [&] { run({mesh, options, reporter, pulse}); });
  return report;
}

}  // namespace unsliver
