#include "verify/delaunay_global.hpp"

#include <algorithm>

#include "verify/judge.hpp"

namespace unsliver::verifier {

Box3 search_box(const Tet& t) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0], c = t[3] - t[0];
  const double det = dot(a, cross(b, c));
  const double reach = std::sqrt(std::max({norm_sq(a), norm_sq(b), norm_sq(c)}));
  if (!(std::abs(det) > 1e-6 * reach * reach * reach)) {
    const double all = std::numeric_limits<double>::infinity();
    return {{-all, -all, -all}, {all, all, all}};
  }
  const Vec3 sum = norm_sq(a) * cross(b, c) + norm_sq(b) * cross(c, a) + norm_sq(c) * cross(a, b);
  const Vec3 radius = (0.5 / det) * sum;
  // Coordinates far from the origin, and input vertices, are only as good as their own rounding.
  const double far = std::max({std::abs(t[0].x), std::abs(t[0].y), std::abs(t[0].z)});
  const double r = norm(radius) * (1 + 1e-6) + 1e-9 * far;
  const Vec3 center = t[0] + radius;
  return {center - Vec3{r, r, r}, center + Vec3{r, r, r}};
}

void check_delaunay_globally(const Context& c, const Sites& sites, const KdTree& vertices) {
  Judge judge(sites, {});
  const std::uint64_t before = c.reporter.count("delaunay");
  for (std::size_t t = 0; t < c.mesh.tets.size(); ++t) {
    c.pulse.beats(1);
    const auto& v = c.mesh.tets[t];
    const Candidate candidate = judge.candidate(v);
    if (candidate.orientation == 0) continue;
    vertices.visit_box(search_box(c.mesh.corners(t)), [&](VertexId e, const Vec3& p) {
      if (std::find(v.begin(), v.end(), e) != v.end() || judge.in_sphere(candidate, e) <= 0) return;
      c.reporter.find("delaunay", {static_cast<std::int64_t>(t), e}, [&] {
        return "vertex " + std::to_string(e) + " at " + full(p) + " is strictly inside the circumsphere of " +
               describe_tet(c.mesh, t);
      });
    });
  }
  c.reporter.report().exact_decisions += judge.exact_decisions();
  c.reporter.report().filtered_decisions += judge.filtered_decisions();
  const std::uint64_t wrong = c.reporter.count("delaunay") - before;
  c.reporter.line("Delaunay, globally: " + (wrong == 0 ? std::string("every circumsphere is empty (exact)")
                                                       : grouped(wrong) + " vertices inside circumspheres"));
}

}  // namespace unsliver::verifier
