#include "verify/sampling_checks.hpp"

namespace unsliver::verifier {

void check_grading(const Context& c, const KdTree& vertices, const std::vector<VertexId>& used) {
  double worst = std::numeric_limits<double>::infinity();
  for (const VertexId v : used) {
    c.pulse.beat();
    const Vec3& p = c.mesh.points[v];
    const auto neighbour = vertices.nearest(p, v);
    const double distance = std::sqrt(neighbour.dist_sq);
    const double lfs = c.options.lfs_lower_bound(p);
    if (lfs > 0) worst = std::min(worst, distance / lfs);
    if (distance >= c.options.grading_constant * lfs * (1 - 1e-12)) continue;
    c.reporter.find("grading", {v, neighbour.id}, [&] {
      return "vertices " + std::to_string(v) + " at " + full(p) + " and " + std::to_string(neighbour.id) +
             " are " + full(distance) + " apart, less than " + brief(c.options.grading_constant) +
             " times lfs >= " + full(lfs);
    });
  }
  const std::uint64_t wrong = c.reporter.count("grading");
  c.reporter.report().worst_grading = std::isfinite(worst) ? worst : 0;
  c.reporter.line("grading: nearest neighbour at least " + brief(c.reporter.report().worst_grading) +
                  " times lfs; the bound " + brief(c.options.grading_constant) + " " +
                  (wrong == 0 ? "holds at all vertices" : "is VIOLATED " + grouped(wrong) + " times"));
}

}  // namespace unsliver::verifier
