#include "mesh_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <span>

#include "box_check.hpp"
#include "files.hpp"
#include "guarantee.hpp"
#include "interrupts.hpp"
#include "progress_display.hpp"
#include "raw_mesh.hpp"
#include "resources.hpp"
#include "samples.hpp"
#include "shape_quality.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "topology_json.hpp"
#include "unsliver/periodic.hpp"
#include "unsliver/stream.hpp"

namespace unsliver::cli {
namespace {

constexpr std::size_t kCoverSamples = 100'000;

constexpr const char* kNoInside =
    "the size bound was not tested: no point was found inside the surface, which has no volume, or next to "
    "none";

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

/// The estimate may be too high by as much; a run that starts is still ended by its caps.
constexpr double kEstimateError = 2;

class MeshRun {
 public:
  MeshRun(const MeshCommandOptions& options, MeshReport& report)
      : options_(options), report_(report), display_(!options.quiet && stderr_is_terminal()) {}

  void run();

 private:
  void prepare();
  void check_limits();
  void generate();
  void make();
  void make_in_pieces();
  void count();
  void judge();
  void judge_arrays();
  void judge_pieces();
  void write();

  void settle(const std::string& status, ExitCode code);
  VerifyOptions verify_options() const;
  std::function<double(const Vec3&)> local_feature_size(const GradingGuarantee& grading) const;
  bool can_test_size() const;
  std::vector<Vec3> points_to_cover() const;
  SizingPtr capped_sizing() const;
  const MeshOptions& asked() const { return *report_.options; }
  QualityLimits limits() const {
    return {asked().min_dihedral_deg, asked().max_dihedral_deg, asked().max_radius_edge};
  }
  bool is_streamed() const { return !options_.stream.empty(); }
  const std::optional<InputVertices>& inputs() const { return report_.source->inputs; }

  /// Errors about the points name them as the file does.
  template <typename Work>
  void with_inputs(Work work) {
    if (!inputs()) return work(std::span<const Vec3>());
    try {
      work(std::span<const Vec3>(inputs()->set.points));
    } catch (const Error& error) {
      throw with_restored_ids(*inputs(), error);
    }
  }

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

void MeshRun::settle(const std::string& status, ExitCode code) {
  report_.status = status;
  report_.exit_code = code;
}

/// Without a cap of the user's, the memory available is the cap: better ended than killed.
void MeshRun::prepare() {
  report_.options = options_.mesh;
  if (asked().max_memory_bytes == 0) report_.options->max_memory_bytes = available_memory();
  report_.source = make_domain(options_.domain);
  report_.size = make_sizing(options_.size, *report_.source);
  with_inputs([this](std::span<const Vec3> points) {
    report_.estimate = estimate_size(*report_.source->domain, *capped_sizing(), points, asked());
  });
  if (is_streamed()) report_.estimate->bytes = kStreamedBytesPerTet * report_.estimate->tets;
}

/// Periodic cells know no sizes beyond a quarter of their shortest side.
SizingPtr MeshRun::capped_sizing() const {
  const auto& cell = report_.source->periodic_cell;
  if (!cell) return report_.size->sizing;
  const Vec3 sides = cell->size();
  return minimum_size({report_.size->sizing, constant_size(0.25 * std::min({sides.x, sides.y, sides.z}))});
}

void MeshRun::check_limits() {
  const SizeEstimate& estimate = *report_.estimate;
  const std::string expected =
      fmt::format("about {} vertices, {} tetrahedra and {} of memory", human_count(estimate.vertices),
                  human_count(estimate.tets), human_bytes(estimate.bytes));
  if (!options_.quiet) say("expecting " + expected);
  const auto [max_tets, max_memory] = std::pair(asked().max_tets, asked().max_memory_bytes);
  const auto surely_exceeds = [](double expected, std::uint64_t limit) {
    return limit > 0 && !(expected <= kEstimateError * static_cast<double>(limit));
  };
  const bool too_many = surely_exceeds(estimate.tets, max_tets);
  const bool too_large = surely_exceeds(estimate.bytes, max_memory);
  if (options_.keep_partial || (!too_many && !too_large)) return;
  const std::string limit = too_many ? "--max-tets " + with_separators(max_tets)
                            : options_.mesh.max_memory_bytes > 0
                                ? "--max-memory " + human_bytes(static_cast<double>(max_memory))
                                : "the memory available, " + human_bytes(static_cast<double>(max_memory));
  throw Error(ErrorCode::kLimit,
              fmt::format("expected are {}, more than {} times {}. Ask for {}, raise the limit, or add "
                          "--keep-partial to run until the limit and keep the unfinished mesh",
                          expected, kEstimateError, limit,
                          inputs() ? "less (--min-angle, --max-angle, --size)" : "larger elements (--size)"));
}

void MeshRun::make() {
  with_inputs([this](std::span<const Vec3> points) {
    const DomainSource& source = *report_.source;
    const Sizing& sizing = *report_.size->sizing;
    const Control& control = display_.control();
    result_ = source.periodic_cell ? mesh_periodic(*source.periodic_cell, sizing, points, asked(), control)
              : source.exact_box   ? mesh_box(*source.exact_box, sizing, asked(), control)
                                   : mesh_domain(*source.domain, sizing, points, asked(), control);
  });
}

void MeshRun::make_in_pieces() {
  folder_.emplace(options_.stream);
  StreamResult made =
      stream_domain(*report_.source->domain, *report_.size->sizing, *folder_, asked(), display_.control());
  result_.status = made.status;
  result_.stats = std::move(made.stats);
  if (made.status != MeshStatus::kDone) return;
  report_.counts = {made.vertices, made.tets, 0, 0};
  folder_->finish(made.limits);
}

void MeshRun::generate() {
  is_streamed() ? make_in_pieces() : make();
  display_.clear();
  report_.stats = result_.stats;
  report_.phases.insert(report_.phases.end(), result_.stats.phases.begin(), result_.stats.phases.end());
  report_.notes.insert(report_.notes.end(), result_.notes.begin(), result_.notes.end());
  settle(to_string(result_.status), result_.status == MeshStatus::kDone ? ExitCode::kDone : ExitCode::kLimit);
  const bool wanted = result_.status != MeshStatus::kCancelled || options_.keep_partial;
  if (!wanted || is_streamed()) return;
  count();
  timed("measure", [this] { report_.quality = summarize_quality(result_.mesh); });
}

void MeshRun::count() {
  const TetMesh& mesh = result_.mesh;
  const auto is_input = [](std::int64_t source) { return source >= 0; };
  const auto inputs = std::count_if(mesh.point_source.begin(), mesh.point_source.end(), is_input);
  report_.counts = {mesh.points.size(), mesh.tets.size(), mesh.triangles.size(),
                    static_cast<std::size_t>(inputs)};
}

/// None of a torus: the volume says more.
std::vector<Vec3> MeshRun::points_to_cover() const {
  if (report_.source->periodic_cell) return {};
  if (!report_.source->surface) return domain_samples(*report_.source->domain, kCoverSamples);
  std::vector<Vec3> points = surface_vertices(*report_.source->surface);
  const std::vector<Vec3> samples = surface_samples(*report_.source->surface, kCoverSamples);
  points.insert(points.end(), samples.begin(), samples.end());
  return points;
}

/// The size bound is tested at random points, and none would fall into a surface whose inside has no volume.
/// Every other kind of domain has some by construction.
bool MeshRun::can_test_size() const {
  const Domain& domain = *report_.source->domain;
  return !report_.source->surface || !domain_samples(domain, 1000).empty() ||
         !domain_samples(domain, kCoverSamples).empty();
}

/// An unfinished mesh promises to be a valid Delaunay mesh that covers the domain, and no more.
VerifyOptions MeshRun::verify_options() const {
  VerifyOptions verify;
  verify.must_cover = points_to_cover();
  verify.cover_tolerance = sample_rounding(verify.must_cover);
  verify.inside = [this](const Vec3& p) { return report_.source->domain->contains(p); };
  if (result_.status != MeshStatus::kDone) return verify;
  verify.guarantee = guarantee_of(limits());
  if (report_.size->demands()) verify.size = [this](const Vec3& p) { return report_.size->sizing->at(p); };
  if (report_.source->periodic_cell) return verify;
  const GradingGuarantee grading = grading_guarantee(result_.stats.strategy, inputs().has_value());
  if (grading.share > 0) verify.lfs_lower_bound = local_feature_size(grading);
  verify.grading_constant = grading.share;
  return verify;
}

std::function<double(const Vec3&)> MeshRun::local_feature_size(const GradingGuarantee& grading) const {
  const Domain& domain = *report_.source->domain;
  const Sizing& sizing = *report_.size->sizing;
  return inputs() ? lfs_lower_bound(domain, sizing, grading, inputs()->set.points)
                  : lfs_lower_bound(domain, sizing, grading);
}

void MeshRun::judge_pieces() {
  RawMeshReader mesh(folder_->place());
  StreamVerifyOptions asked;
  asked.guarantee = guarantee_of(limits());
  asked.inside = [this](const Vec3& p) { return report_.source->domain->contains(p); };
  StreamVerifyReport verified = verify_stream(mesh, asked, display_.control());
  report_.quality = summarize_quality(verified.shapes);
  report_.verified = std::move(verified);
}

void MeshRun::judge_arrays() {
  VerifyOptions asked = verify_options();
  if (asked.size && !can_test_size()) {
    asked.size = nullptr;
    report_.notes.emplace_back(kNoInside);
  }
  report_.verified = verify(result_.mesh, asked, display_.control());
  if (inputs()) check_inputs(result_.mesh, inputs()->set.points, *report_.verified);
  if (report_.source->exact_box) check_box(result_.mesh, *report_.source->exact_box, *report_.verified);
}

void MeshRun::judge() {
  is_streamed() ? judge_pieces() : judge_arrays();
  display_.clear();
  if (interrupts::requested()) {
    report_.verified.reset();
    settle("unverified", ExitCode::kLimit);
  } else if (!report_.verified->ok) {
    settle("verification_failed", ExitCode::kBug);
  } else {
    const bool done = result_.status == MeshStatus::kDone;
    round_extremes(done ? limits() : QualityLimits{}, *report_.verified, *report_.quality);
  }
}

void MeshRun::write() {
  hold_.emplace(interrupts::Hold::For::kFile);
  if (is_streamed()) {
    folder_->commit();
    report_.output = options_.stream;
    return;
  }
  if (inputs()) restore_ids(*inputs(), result_.mesh);
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
