#include "verify/shape_census.hpp"

#include "verify/bounds.hpp"
#include "verify/shape.hpp"
#include "verify/tetrahedra_check.hpp"

namespace unsliver::verifier {
namespace {

Row<BigInt> exact(const Row<std::int64_t>& row) { return {BigInt(row[0]), BigInt(row[1]), BigInt(row[2])}; }

std::string outcome(const Reporter& reporter, const char* check) {
  const std::uint64_t wrong = reporter.count(check);
  return wrong == 0 ? "holds (exact)" : "is VIOLATED by " + grouped(wrong) + " shapes";
}

/// One tetrahedron of each shape, at the origin.
struct Samples {
  TetMesh mesh;
  std::vector<Row<std::int64_t>> places;

  void add(const Differences& shape) {
    const auto first = static_cast<VertexId>(places.size());
    places.push_back({0, 0, 0});
    places.insert(places.end(), shape.begin(), shape.end());
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
    for (std::size_t i = first; i < places.size(); ++i)
      mesh.points.push_back({double(places[i][0]), double(places[i][1]), double(places[i][2])});
  }

  Tet last_corners(double unit) const {
    Tet corners = mesh.corners(mesh.tets.size() - 1);
    for (Vec3& p : corners) p = unit * p;
    return corners;
  }
};

void report_quality(const StreamContext& c, std::size_t shapes) {
  const VerifyReport& r = c.report;
  const std::uint64_t wrong = c.reporter.count("orientation");
  c.reporter.line("orientation: " + grouped(c.head.tets) + " tetrahedra of " + grouped(shapes) + " shapes, " +
                  (wrong == 0 ? "all positive (exact)" : grouped(wrong) + " shapes NOT positive"));
  std::string angles =
      "dihedral angles: in [" + brief(r.min_dihedral_deg) + ", " + brief(r.max_dihedral_deg) + "] degrees";
  std::string ratio = "radius-edge ratio: at most " + brief(r.max_radius_edge);
  if (const auto& g = c.options.guarantee) {
    angles += "; guarantee [" + brief(g->min_dihedral_deg) + ", " + brief(g->max_dihedral_deg) + "] " +
              outcome(c.reporter, "dihedral");
    ratio += "; guarantee " + brief(g->max_radius_edge) + " " + outcome(c.reporter, "radius-edge");
  }
  c.reporter.line(angles);
  c.reporter.line(ratio);
}

}  // namespace

void ShapeCensus::judge(const StreamContext& c) const {
  std::vector<std::pair<Count, const Differences*>> order;
  for (const auto& [shape, count] : shapes_) order.push_back({count, &shape});
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first.first_tet < b.first.first_tet; });
  Samples samples;
  for (const auto& [count, shape] : order) {
    samples.add(*shape);
    c.report.shapes.push_back({count.first_tet, count.tets, samples.last_corners(c.head.frame.unit)});
  }

  VerifyReport of_samples;
  Reporter reporter(of_samples, order.size());
  VerifyOptions options;
  options.guarantee = c.options.guarantee;
  check_tetrahedra({samples.mesh, options, reporter, c.pulse}, Sites(samples.places, c.head.frame.unit), {});

  for (const Finding& finding : of_samples.findings) {
    const auto sample = static_cast<std::size_t>(finding.ids[0]);
    const Count& count = order[sample].first;
    c.reporter.find(finding.check, {static_cast<std::int64_t>(count.first_tet)}, [&] {
      return "tetrahedron " + std::to_string(count.first_tet) + ", with " + grouped(count.tets - 1) +
             " more of its shape," + finding.message.substr(describe_tet(samples.mesh, sample).size());
    });
  }
  VerifyReport& report = c.report;
  report.min_dihedral_deg = of_samples.min_dihedral_deg;
  report.max_dihedral_deg = of_samples.max_dihedral_deg;
  report.max_radius_edge = of_samples.max_radius_edge;
  report.exact_decisions += of_samples.exact_decisions;
  report.filtered_decisions += of_samples.filtered_decisions;
  report_quality(c, order.size());
}

BigInt ShapeCensus::six_volumes() const {
  BigInt sum = 0;
  for (const auto& [d, count] : shapes_)
    sum += dot(exact(d[0]), cross(exact(d[1]), exact(d[2]))) * count.tets;
  return sum;
}

}  // namespace unsliver::verifier
