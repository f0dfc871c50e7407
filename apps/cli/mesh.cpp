/// \file
/// `unsliver mesh`: read, estimate, mesh, verify, write, report.
#include <memory>

#include "commands.hpp"
#include "files.hpp"
#include "interrupts.hpp"
#include "mesh_options.hpp"
#include "mesh_report.hpp"
#include "mesh_run.hpp"
#include "terminal.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver mesh spot.obj -o spot.vtu --size 0.02
  unsliver mesh part.stl -o part.msh --edge-length 1.5 --size-gradation 0.3 --size-max 10
  unsliver mesh --box "0 0 0 1 1 2" -o box.mesh --size "0.02 + 0.1 * z"
  unsliver mesh --implicit "x^2 + y^2 + z^2 - 1 - 0.2 * sin(9 * x)" \
                --bounds "-2 -2 -2 2 2 2" -o blob.vtu --max-tets 20M --keep-partial
The mesh is a superset of the domain: all tetrahedra that meet it, none of them bad.)text";

/// What a script or a person gets at the end, whatever the end was.
void publish(const MeshCommandOptions& options, const MeshReport& report) {
  const interrupts::Hold hold(interrupts::Hold::For::kFile);
  if (!options.quiet && options.json != "-" && !report.error) print_result(to_table(report));
  if (!options.json.empty()) write_json(options.json, to_json(report).dump(2) + "\n");
}

void publish_error(const MeshCommandOptions& options, MeshReport& report, const Error& error) {
  report.error = error;
  report.status = error.code() == ErrorCode::kLimit ? "refused" : "error";
  report.exit_code = exit_code_of(error.code());
  report.output.clear();
  try {
    publish(options, report);
  } catch (const Error& second) {
    say_error(second.what());
  }
}

ExitCode run(MeshCommandOptions& options) {
  check_mesh_files(options);
  MeshReport report;
  try {
    check_mesh_options(options);
    run_mesh(options, report);
  } catch (const Error& error) {
    publish_error(options, report, error);
    throw;
  }
  publish(options, report);
  return report.exit_code;
}

}  // namespace

Command add_mesh(CLI::App& app) {
  const auto options = std::make_shared<MeshCommandOptions>();
  CLI::App* const parser =
      app.add_subcommand("mesh", "Mesh a solid: every dihedral angle between 30 and 135 degrees");
  add_mesh_options(*parser, *options);
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
