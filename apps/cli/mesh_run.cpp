#include "mesh_run.hpp"

#include <fmt/format.h>

#include <chrono>

#include "files.hpp"
#include "guarantee.hpp"
#include "interrupts.hpp"
#include "mesh_job.hpp"
#include "progress_display.hpp"
#include "raw_mesh.hpp"
#include "shape_quality.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "topology_json.hpp"
#include "unsliver/stream.hpp"

namespace unsliver::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The only format with a place for the angle of each tetrahedron.
bool writes_vtu(const MeshCommandOptions& options) {
  return options.write.format.empty() ? extension_of(options.output) == "vtu" : options.write.format == "vtu";
}

/// What the octree strategy holds of a mesh that it need not hold.
constexpr double kStreamedBytesPerTet = 1.5;

class MeshRun {
 public:
  MeshRun(const MeshCommandOptions& options, MeshReport& report)
      : options_(options), report_(report), display_(!options.quiet && stderr_is_terminal()) {}

  void run();

 private:
  void prepare();
  void check_limits();
  void generate();
  void make_in_pieces();
  void judge();
  void judge_pieces();
  void write();

  bool is_streamed() const { return !options_.stream.empty(); }

  template <typename Work>
  void timed(const std::string& name, Work work) {
    display_.show(name + " ...");
    const auto start = Clock::now();
    work();
    report_.phases.push_back({name, seconds_since(start)});
    display_.clear();
  }

  const MeshCommandOptions& options_;
  MeshReport& report_;
  ProgressDisplay display_;
  std::optional<interrupts::Hold> hold_;
  MeshResult result_;                    ///< without its mesh where that is in the folder
  std::optional<RawMeshWriter> folder_;  ///< of --stream
};

void MeshRun::run() {
  const auto start = Clock::now();
  timed("read", [this] { prepare(); });
  check_limits();
  if (options_.keep_partial || is_streamed() || !options_.json.empty())
    hold_.emplace(interrupts::Hold::For::kOutcome);
  generate();
  const bool has_mesh =
      result_.status != MeshStatus::kCancelled && report_.counts && report_.counts->tets > 0;
  if (!options_.no_verify && has_mesh) timed("verify", [this] { judge(); });
  const bool wanted = report_.exit_code == ExitCode::kDone ||
                      (report_.exit_code == ExitCode::kLimit && options_.keep_partial);
  if (wanted) timed("write", [this] { write(); });
  report_.total_seconds = seconds_since(start);
}

void MeshRun::prepare() {
  add_options(report_, options_.mesh);
  report_.source = make_domain(options_.domain);
  plan_mesh(report_, options_.size);
  if (is_streamed()) report_.estimate->bytes = kStreamedBytesPerTet * report_.estimate->tets;
}

void MeshRun::check_limits() {
  if (!options_.quiet) say("expecting " + expected_text(*report_.estimate));
  if (!options_.keep_partial) check_estimate(report_, options_.mesh);
}

void MeshRun::make_in_pieces() {
  folder_.emplace(options_.stream);
  StreamResult made = stream_domain(*report_.source->domain, *report_.size->sizing, *folder_,
                                    *report_.options, display_.control());
  result_.status = made.status;
  result_.stats = std::move(made.stats);
  if (made.status != MeshStatus::kDone) return;
  report_.counts = {made.vertices, made.tets, 0, 0};
  folder_->finish(made.limits);
}

void MeshRun::generate() {
  if (is_streamed())
    make_in_pieces();
  else
    result_ = make_mesh(report_, display_.control());
  display_.clear();
  add_outcome(report_, result_.status, result_.stats);
  const bool wanted = result_.status != MeshStatus::kCancelled || options_.keep_partial;
  if (!wanted || is_streamed()) return;
  add_counts(report_, result_.mesh);
  timed("measure", [this] { report_.quality = summarize_quality(result_.mesh); });
}

void MeshRun::judge_pieces() {
  RawMeshReader mesh(folder_->place());
  StreamVerifyOptions asked;
  asked.guarantee = guarantee_of(limits_of(*report_.options));
  asked.inside = [this](const Vec3& p) { return report_.source->domain->contains(p); };
  StreamVerifyReport verified = verify_stream(mesh, asked, display_.control());
  report_.quality = summarize_quality(verified.shapes);
  report_.verified = std::move(verified);
}

void MeshRun::judge() {
  if (is_streamed())
    judge_pieces();
  else
    judge_mesh(report_, result_, display_.control());
  display_.clear();
  conclude(report_, interrupts::requested());
}

void MeshRun::write() {
  hold_.emplace(interrupts::Hold::For::kFile);
  if (is_streamed()) {
    folder_->commit();
    report_.output = options_.stream;
    return;
  }
  if (report_.source->inputs) restore_ids(*report_.source->inputs, result_.mesh);
  io::WriteOptions write = options_.write;
  if (writes_vtu(options_)) write.min_dihedral_deg = min_dihedral_angles_deg(result_.mesh);
  io::write_tet_mesh(options_.output, result_.mesh, write);
  if (!options_.topology.empty()) write_json(options_.topology, topology_json(result_.mesh).dump() + "\n");
  report_.output = options_.output;
}

std::string end_of_run(const std::string& status) {
  if (status == "tet_cap") return "the cap on tetrahedra ended the run";
  if (status == "memory_cap") return "the cap on memory ended the run";
  return "interrupted";
}

void warn_of_limit(const MeshReport& report, bool keep_partial) {
  std::string fate = "; nothing was written";
  if (!keep_partial) fate += " (--keep-partial would keep the unfinished mesh)";
  if (!report.output.empty() && report.status == "unverified")
    fate = "; " + report.output + " holds the finished mesh, not verified";
  else if (!report.output.empty())
    fate = "; " + report.output + " holds an UNFINISHED mesh: valid, but without the guarantees";
  say_warning(end_of_run(report.status) + fate);
}

void cry_for_help(const VerifyReport& verified) {
  for (const Finding& finding : verified.findings) say_error(finding.check + ": " + finding.message);
  say_error(
      fmt::format("THE MESH FAILED ITS INDEPENDENT VERIFICATION ({}). It was not written. This is a bug in "
                  "unsliver: please report it with this command. --no-verify writes the mesh all the same",
                  plural(verified.finding_count, "finding")));
}

}  // namespace

void run_mesh(const MeshCommandOptions& options, MeshReport& report) {
  MeshRun(options, report).run();
  if (report.exit_code == ExitCode::kLimit) warn_of_limit(report, options.keep_partial);
  if (report.exit_code == ExitCode::kBug) cry_for_help(*report.verified);
}

}  // namespace unsliver::cli
