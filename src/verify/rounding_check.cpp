#include "verify/rounding_check.hpp"

#include <algorithm>
#include <numbers>

#include "verify/judge.hpp"
#include "verify/orientation.hpp"

namespace unsliver::verifier {
namespace {

struct AngleRange {
  double min_deg = 180, max_deg = 0;
};

void add_angles(const Tet& t, AngleRange& range) {
  std::array<Row<double>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 d = t[i + 1] - t[0];
    edge[i] = {d.x, d.y, d.z};
  }
  const Shape<double> s = make_shape(edge);
  for (const FacePair& f : kFacePairs) {
    const double angle =
        std::atan2(s.det * std::sqrt(edge_sq(s, f)), cosine_part(s, f)) * (180 / std::numbers::pi);
    range.min_deg = std::min(range.min_deg, angle);
    range.max_deg = std::max(range.max_deg, angle);
  }
}

}  // namespace

void check_rounding(const Context& c, const FramePlaces& places) {
  if (places.off_grid.empty()) return;
  std::vector<bool> moved(c.mesh.points.size(), false);
  for (const VertexId v : places.off_grid) moved[v] = true;
  SignCounts counts;
  AngleRange range;
  std::uint64_t touched = 0;
  for (std::size_t t = 0; t < c.mesh.tets.size(); ++t) {
    const auto& v = c.mesh.tets[t];
    if (std::none_of(v.begin(), v.end(), [&](VertexId w) { return moved[w]; })) continue;
    ++touched;
    const Tet corners = c.mesh.corners(t);
    add_angles(corners, range);
    if (orientation_sign(corners[0], corners[1], corners[2], corners[3], counts) > 0) continue;
    c.reporter.find("orientation", {static_cast<std::int64_t>(t)}, [&] {
      return describe_tet(c.mesh, t) + " is not positive at the given coordinates of its input vertices";
    });
  }
  c.reporter.report().exact_decisions += counts.exact;
  c.reporter.report().filtered_decisions += counts.filtered;
  c.reporter.line("rounding: " + grouped(places.off_grid.size()) +
                  " input vertices judged at the nearest grid point, at most " + brief(places.worst_offset) +
                  " units along an axis (unit " + brief(c.mesh.frame->unit) +
                  "); where they really are, the " + grouped(touched) +
                  " tetrahedra around them have angles in [" + full(range.min_deg) + ", " +
                  full(range.max_deg) + "]");
}

}  // namespace unsliver::verifier
