/// \file
/// `unsliver check`: an independent judgement of anybody's tetrahedral mesh.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>

#include "check_report.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "guarantee.hpp"
#include "mesh_report.hpp"
#include "progress_display.hpp"
#include "raw_mesh.hpp"
#include "samples.hpp"
#include "shape_quality.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "unsliver/io.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver check mesh.vtu
  unsliver check mesh.vtu --against part.stl --json report.json
  unsliver check other.msh --min-angle 10 --worst 20
Any mesh: orientation and conformity, decided exactly. Meshes of unsliver (they carry their lattice):
the Delaunay property, lattice membership and the limits on angles and radius-edge ratio they were made
for as well; files other than .vtu do not hold these limits, and 30 and 135 degrees are taken. With
--against, the surface's vertices must be covered (in meshes of unsliver also 100,000 samples of the
surface, and the inside beyond each facet that the mesh ends at). --min-angle, --max-angle and
--max-radius-edge each replace one of the mesh's own limits.
Exit code 0: no fault found (poor angles alone are no fault unless promised or asked for); 1: the mesh
is not what it should be; 2: the mesh could not be read.)text";

constexpr std::size_t kCoverSamples = 100'000;

struct CheckOptions {
  std::string mesh, against, json;
  std::optional<double> min_angle, max_angle, max_radius_edge;
  std::size_t worst = 5;
  bool quiet = false;
};

/// Meshes of unsliver carry their lattice.
bool is_ours(const TetMesh& mesh) { return mesh.frame.has_value() && !mesh.levels.empty(); }

/// Level 0 is no lattice's.
bool has_input_vertices(const TetMesh& mesh) {
  return std::find(mesh.levels.begin(), mesh.levels.end(), 0) != mesh.levels.end();
}

/// What is due of it in the first place: what its file says, else what meshes of ours promise by default.
std::optional<QualityLimits> limits_due(const TetMesh& mesh) {
  if (mesh.limits || !is_ours(mesh)) return mesh.limits;
  const MeshOptions strictest;
  return QualityLimits{strictest.min_dihedral_deg, strictest.max_dihedral_deg,
                       least_radius_edge(has_input_vertices(mesh))};
}

/// What the mesh is held to: what is due, each limit replaced by what was asked for.
std::optional<QualityLimits> limits_to_hold(const CheckOptions& options,
                                            const std::optional<QualityLimits>& due) {
  if (!due && !options.min_angle && !options.max_angle && !options.max_radius_edge) return std::nullopt;
  const QualityLimits limits = due.value_or(QualityLimits{});
  return QualityLimits{options.min_angle.value_or(limits.min_dihedral_deg),
                       options.max_angle.value_or(limits.max_dihedral_deg),
                       options.max_radius_edge.value_or(limits.max_radius_edge)};
}

/// \throws Error kBadOption for a bound that no angle or ratio can meet.
void check_bounds(const CheckOptions& options) {
  const auto within = [](const char* option, const std::optional<double>& value, double low, double high) {
    if (value && !(low <= *value && *value <= high))
      throw Error(ErrorCode::kBadOption,
                  fmt::format("{} is {}: it must lie between {} and {}", option, *value, low, high));
  };
  within("--min-angle", options.min_angle, 0, 70.528779);
  within("--max-angle", options.max_angle, 70.528779, 180);
  within("--max-radius-edge", options.max_radius_edge, 0.612372, std::numeric_limits<double>::infinity());
}

std::function<bool(const Vec3&)> inside_of(const TriangleMesh& surface) {
  return [domain = make_surface(surface)](const Vec3& p) { return domain->contains(p); };
}

/// Meshes of others need not follow the surface between its vertices.
void hold_against(const TriangleMesh& surface, bool ours, VerifyOptions& options) {
  options.must_cover = surface_vertices(surface);
  if (ours) {
    const std::vector<Vec3> samples = surface_samples(surface, kCoverSamples);
    options.must_cover.insert(options.must_cover.end(), samples.begin(), samples.end());
    options.inside = inside_of(surface);
  }
  options.cover_tolerance = sample_rounding(options.must_cover);
}

void conclude(CheckReport& report) {
  if (report.verified.ok)
    round_extremes(report.held_to.value_or(QualityLimits{}), report.verified, report.quality);
  report.exit_code = report.verified.ok ? ExitCode::kDone : ExitCode::kLimit;
}

CheckReport judge(const CheckOptions& options, const TetMesh& mesh) {
  CheckReport report;
  report.file = options.mesh;
  report.against = options.against;
  report.vertices = mesh.points.size();
  for (const Vec3& p : mesh.points) report.bounds.extend(p);
  report.ours = is_ours(mesh);
  report.held_to = limits_to_hold(options, limits_due(mesh));
  report.quality = summarize_quality(mesh, options.worst);

  VerifyOptions verify_options;
  if (report.held_to) verify_options.guarantee = guarantee_of(*report.held_to);
  verify_options.delaunay = report.ours;
  if (!options.against.empty()) hold_against(io::read_surface(options.against), report.ours, verify_options);
  ProgressDisplay display(!options.quiet && stderr_is_terminal());
  report.verified = verify(mesh, verify_options, display.control());
  conclude(report);
  return report;
}

/// A folder of mesh --stream, which need not fit into memory.
CheckReport judge_pieces(const CheckOptions& options) {
  RawMeshReader mesh(options.mesh);
  CheckReport report;
  report.file = options.mesh;
  report.against = options.against;
  report.vertices = mesh.head().vertices;
  report.ours = true;
  report.held_to = limits_to_hold(options, mesh.limits());

  StreamVerifyOptions verify_options;
  if (report.held_to) verify_options.guarantee = guarantee_of(*report.held_to);
  if (!options.against.empty()) verify_options.inside = inside_of(io::read_surface(options.against));
  ProgressDisplay display(!options.quiet && stderr_is_terminal());
  StreamVerifyReport verified = verify_stream(mesh, verify_options, display.control());
  report.bounds = verified.bounds;
  report.quality = summarize_quality(verified.shapes, options.worst);
  report.verified = std::move(verified);
  conclude(report);
  return report;
}

ExitCode run(const CheckOptions& options) {
  check_bounds(options);
  const bool raw = is_raw_mesh(options.mesh);
  if (!raw) check_readable(options.mesh);
  if (!options.against.empty()) check_readable(options.against);
  check_distinct({options.json}, {options.mesh, options.against});
  if (!options.json.empty() && options.json != "-") check_writable(options.json, "--json");
  const CheckReport report = raw ? judge_pieces(options) : judge(options, io::read_tet_mesh(options.mesh));
  if (!options.quiet && options.json != "-") print_result(to_table(report));
  if (!options.json.empty()) write_json(options.json, to_json(report).dump(2) + "\n");
  if (!report.verified.ok)
    say_error(
        options.mesh + ": " + plural(report.verified.finding_count, "finding") +
        (report.verified.findings.empty() ? "" : "; the first: " + report.verified.findings.front().message));
  return report.exit_code;
}

}  // namespace

Command add_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* const parser =
      app.add_subcommand("check", "Judge any tetrahedral mesh: validity, angles, worst elements");
  parser
      ->add_option("MESH", options->mesh,
                   "mesh file: .vtu .msh .mesh .node .ele, or a folder of mesh --stream")
      ->required();
  parser->add_option("--against", options->against, "surface file that the mesh must cover");
  parser->add_option("--min-angle", options->min_angle,
                     "hold it to this smallest dihedral angle, in degrees");
  parser->add_option("--max-angle", options->max_angle, "hold it to this largest dihedral angle, in degrees");
  parser->add_option("--max-radius-edge", options->max_radius_edge, "hold it to this radius-edge ratio");
  parser->add_option("--worst", options->worst, "how many of the worst tetrahedra to list (default 5)")
      ->check(CLI::NonNegativeNumber);
  parser->add_option("--json", options->json, "report for machines: a file, or - for standard output");
  parser->add_flag("--quiet", options->quiet, "print errors only");
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
