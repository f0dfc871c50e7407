#include "mesh_command.hpp"

#include "files.hpp"
#include "interrupts.hpp"
#include "mesh_report.hpp"
#include "mesh_run.hpp"
#include "terminal.hpp"

namespace unsliver::cli {
namespace {

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

}  // namespace

ExitCode run_mesh_command(MeshCommandOptions& options) {
  check_mesh_files(options);
  MeshReport report;
  report.command = options.domain.mesh_file ? "refine" : "mesh";
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

}  // namespace unsliver::cli
