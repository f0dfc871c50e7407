/// \file
/// `unsliver check`: an independent judgement of anybody's tetrahedral mesh.
#include <memory>

#include "check_mesh.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "guarantee.hpp"
#include "progress_display.hpp"
#include "raw_mesh.hpp"
#include "shape_quality.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "unsliver/io.hpp"

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

struct CheckOptions {
  std::string mesh, against, json;
  CheckDemands demands;
  bool quiet = false;
};

CheckReport judge(const CheckOptions& options) {
  std::optional<TriangleMesh> against;
  const TetMesh mesh = io::read_tet_mesh(options.mesh);
  if (!options.against.empty()) against = io::read_surface(options.against);
  ProgressDisplay display(!options.quiet && stderr_is_terminal());
  CheckReport report = check_mesh(mesh, against ? &*against : nullptr, options.demands, display.control());
  report.file = options.mesh;
  report.against = options.against;
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
  report.held_to = limits_to_hold(options.demands, mesh.limits());

  StreamVerifyOptions verify_options;
  if (report.held_to) verify_options.guarantee = guarantee_of(*report.held_to);
  if (!options.against.empty()) verify_options.inside = inside_of(io::read_surface(options.against));
  ProgressDisplay display(!options.quiet && stderr_is_terminal());
  StreamVerifyReport verified = verify_stream(mesh, verify_options, display.control());
  report.bounds = verified.bounds;
  report.quality = summarize_quality(verified.shapes, options.demands.worst);
  report.verified = std::move(verified);
  conclude(report);
  return report;
}

ExitCode run(const CheckOptions& options) {
  check_demands(options.demands);
  const bool raw = is_raw_mesh(options.mesh);
  if (!raw) check_readable(options.mesh);
  if (!options.against.empty()) check_readable(options.against);
  check_distinct({options.json}, {options.mesh, options.against});
  if (!options.json.empty() && options.json != "-") check_writable(options.json, "--json");
  const CheckReport report = raw ? judge_pieces(options) : judge(options);
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
  parser->add_option("--min-angle", options->demands.min_angle,
                     "hold it to this smallest dihedral angle, in degrees");
  parser->add_option("--max-angle", options->demands.max_angle,
                     "hold it to this largest dihedral angle, in degrees");
  parser->add_option("--max-radius-edge", options->demands.max_radius_edge,
                     "hold it to this radius-edge ratio");
  parser
      ->add_option("--worst", options->demands.worst, "how many of the worst tetrahedra to list (default 5)")
      ->check(CLI::NonNegativeNumber);
  parser->add_option("--json", options->json, "report for machines: a file, or - for standard output");
  parser->add_flag("--quiet", options->quiet, "print errors only");
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
