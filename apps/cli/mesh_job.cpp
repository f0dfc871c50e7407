#include "mesh_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "box_check.hpp"
#include "guarantee.hpp"
#include "resources.hpp"
#include "samples.hpp"
#include "text.hpp"
#include "unsliver/periodic.hpp"

namespace unsliver::cli {
namespace {

constexpr std::size_t kCoverSamples = 100'000;

constexpr const char* kNoInside =
    "the size bound was not tested: no point was found inside the surface, which has no volume, or next to "
    "none";

/// The estimate may be too high by as much; a run that starts is still ended by its caps.
constexpr double kEstimateError = 2;

/// Errors about the points name them as their file does.
template <typename Work>
auto with_inputs(const std::optional<InputVertices>& inputs, Work work) {
  if (!inputs) return work(std::span<const Vec3>());
  try {
    return work(std::span<const Vec3>(inputs->set.points));
  } catch (const Error& error) {
    throw with_restored_ids(*inputs, error);
  }
}

/// Periodic cells know no sizes beyond a quarter of their shortest side.
SizingPtr capped_sizing(const MeshReport& report) {
  const auto& cell = report.source->periodic_cell;
  if (!cell) return report.size->sizing;
  const Vec3 sides = cell->size();
  return minimum_size({report.size->sizing, constant_size(0.25 * std::min({sides.x, sides.y, sides.z}))});
}

/// None of a torus: the volume says more.
std::vector<Vec3> points_to_cover(const DomainSource& source) {
  if (source.periodic_cell) return {};
  if (!source.surface) return domain_samples(*source.domain, kCoverSamples);
  std::vector<Vec3> points = surface_vertices(*source.surface);
  const std::vector<Vec3> samples = surface_samples(*source.surface, kCoverSamples);
  points.insert(points.end(), samples.begin(), samples.end());
  return points;
}

/// The size bound is tested at random points, and none would fall into a surface whose inside has no volume.
/// Every other kind of domain has some by construction.
bool can_test_size(const DomainSource& source) {
  return !source.surface || !domain_samples(*source.domain, 1000).empty() ||
         !domain_samples(*source.domain, kCoverSamples).empty();
}

std::function<double(const Vec3&)> local_feature_size(const MeshReport& report,
                                                      const GradingGuarantee& grading) {
  const Domain& domain = *report.source->domain;
  const Sizing& sizing = *report.size->sizing;
  return report.source->inputs ? lfs_lower_bound(domain, sizing, grading, report.source->inputs->set.points)
                               : lfs_lower_bound(domain, sizing, grading);
}

/// An unfinished mesh promises to be a valid Delaunay mesh that covers the domain, and no more.
VerifyOptions what_is_due(const MeshReport& report) {
  VerifyOptions due;
  due.must_cover = points_to_cover(*report.source);
  due.cover_tolerance = sample_rounding(due.must_cover);
  due.inside = [&report](const Vec3& p) { return report.source->domain->contains(p); };
  if (!report.guaranteed()) return due;
  due.guarantee = guarantee_of(limits_of(*report.options));
  if (report.size->demands()) due.size = [&report](const Vec3& p) { return report.size->sizing->at(p); };
  if (report.source->periodic_cell) return due;
  const GradingGuarantee grading =
      grading_guarantee(report.stats->strategy, report.source->inputs.has_value());
  if (grading.share > 0) due.lfs_lower_bound = local_feature_size(report, grading);
  due.grading_constant = grading.share;
  return due;
}

}  // namespace

QualityLimits limits_of(const MeshOptions& options) {
  return {options.min_dihedral_deg, options.max_dihedral_deg, options.max_radius_edge};
}

void add_options(MeshReport& report, const MeshOptions& asked) {
  report.options = asked;
  if (asked.max_memory_bytes == 0) report.options->max_memory_bytes = available_memory();
}

void plan_mesh(MeshReport& report, const SizeRequest& size) {
  report.size = make_sizing(size, *report.source);
  report.estimate = with_inputs(report.source->inputs, [&](std::span<const Vec3> points) {
    return estimate_size(*report.source->domain, *capped_sizing(report), points, *report.options);
  });
}

std::string expected_text(const SizeEstimate& estimate) {
  return fmt::format("about {} vertices, {} tetrahedra and {} of memory", human_count(estimate.vertices),
                     human_count(estimate.tets), human_bytes(estimate.bytes));
}

void check_estimate(const MeshReport& report, const MeshOptions& asked) {
  const std::uint64_t max_tets = report.options->max_tets, max_memory = report.options->max_memory_bytes;
  const auto surely_exceeds = [](double expected, std::uint64_t limit) {
    return limit > 0 && !(expected <= kEstimateError * static_cast<double>(limit));
  };
  const bool too_many = surely_exceeds(report.estimate->tets, max_tets);
  if (!too_many && !surely_exceeds(report.estimate->bytes, max_memory)) return;
  const std::string limit = too_many ? "--max-tets " + with_separators(max_tets)
                            : asked.max_memory_bytes > 0
                                ? "--max-memory " + human_bytes(static_cast<double>(max_memory))
                                : "the memory available, " + human_bytes(static_cast<double>(max_memory));
  throw Error(ErrorCode::kLimit,
              fmt::format("expected are {}, more than {} times {}. Ask for {}, raise the limit, or add "
                          "--keep-partial to run until the limit and keep the unfinished mesh",
                          expected_text(*report.estimate), kEstimateError, limit,
                          report.source->inputs ? "less (--min-angle, --max-angle, --size)"
                                                : "larger elements (--size)"));
}

MeshResult make_mesh(MeshReport& report, const Control& control) {
  const DomainSource& source = *report.source;
  const Sizing& sizing = *report.size->sizing;
  MeshResult result = with_inputs(source.inputs, [&](std::span<const Vec3> points) {
    const MeshOptions& options = *report.options;
    return source.periodic_cell ? mesh_periodic(*source.periodic_cell, sizing, points, options, control)
           : source.exact_box   ? mesh_box(*source.exact_box, sizing, options, control)
                                : mesh_domain(*source.domain, sizing, points, options, control);
  });
  report.notes.insert(report.notes.end(), result.notes.begin(), result.notes.end());
  return result;
}

void add_outcome(MeshReport& report, MeshStatus status, const MeshStats& stats) {
  report.stats = stats;
  report.phases.insert(report.phases.end(), stats.phases.begin(), stats.phases.end());
  report.status = to_string(status);
  report.exit_code = status == MeshStatus::kDone ? ExitCode::kDone : ExitCode::kLimit;
}

void add_counts(MeshReport& report, const TetMesh& mesh) {
  const auto is_input = [](std::int64_t source) { return source >= 0; };
  const auto inputs = std::count_if(mesh.point_source.begin(), mesh.point_source.end(), is_input);
  report.counts = {mesh.points.size(), mesh.tets.size(), mesh.triangles.size(),
                   static_cast<std::size_t>(inputs)};
}

void judge_mesh(MeshReport& report, const MeshResult& result, const Control& control) {
  const DomainSource& source = *report.source;
  VerifyOptions due = what_is_due(report);
  if (due.size && !can_test_size(source)) {
    due.size = nullptr;
    report.notes.emplace_back(kNoInside);
  }
  report.verified = verify(result.mesh, due, control);
  if (source.inputs) check_inputs(result.mesh, source.inputs->set.points, *report.verified);
  if (source.exact_box) check_box(result.mesh, *source.exact_box, *report.verified);
}

void conclude(MeshReport& report, bool interrupted) {
  if (interrupted) {
    report.verified.reset();
    report.status = "unverified";
    report.exit_code = ExitCode::kLimit;
  } else if (!report.verified->ok) {
    report.status = "verification_failed";
    report.exit_code = ExitCode::kBug;
  } else {
    const QualityLimits kept = report.guaranteed() ? limits_of(*report.options) : QualityLimits{};
    round_extremes(kept, *report.verified, *report.quality);
  }
}

}  // namespace unsliver::cli
