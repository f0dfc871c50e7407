#include "check_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "guarantee.hpp"
#include "mesh_report.hpp"
#include "samples.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::cli {
namespace {

constexpr std::size_t kCoverSamples = 100'000;

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

}  // namespace

void check_demands(const CheckDemands& demands) {
  const auto within = [](const char* option, const std::optional<double>& value, double low, double high) {
    if (value && !(low <= *value && *value <= high))
      throw Error(ErrorCode::kBadOption,
                  fmt::format("{} is {}: it must lie between {} and {}", option, *value, low, high));
  };
  within("--min-angle", demands.min_angle, 0, 70.528779);
  within("--max-angle", demands.max_angle, 70.528779, 180);
  within("--max-radius-edge", demands.max_radius_edge, 0.612372, std::numeric_limits<double>::infinity());
}

std::optional<QualityLimits> limits_to_hold(const CheckDemands& demands,
                                            const std::optional<QualityLimits>& due) {
  if (!due && !demands.min_angle && !demands.max_angle && !demands.max_radius_edge) return std::nullopt;
  const QualityLimits limits = due.value_or(QualityLimits{});
  return QualityLimits{demands.min_angle.value_or(limits.min_dihedral_deg),
                       demands.max_angle.value_or(limits.max_dihedral_deg),
                       demands.max_radius_edge.value_or(limits.max_radius_edge)};
}

std::function<bool(const Vec3&)> inside_of(const TriangleMesh& surface) {
  return [domain = make_surface(surface)](const Vec3& p) { return domain->contains(p); };
}

void conclude(CheckReport& report) {
  if (report.verified.ok)
    round_extremes(report.held_to.value_or(QualityLimits{}), report.verified, report.quality);
  report.exit_code = report.verified.ok ? ExitCode::kDone : ExitCode::kLimit;
}

CheckReport check_mesh(const TetMesh& mesh, const TriangleMesh* against, const CheckDemands& demands,
                       const Control& control) {
  CheckReport report;
  report.vertices = mesh.points.size();
  for (const Vec3& p : mesh.points) report.bounds.extend(p);
  report.ours = is_ours(mesh);
  report.held_to = limits_to_hold(demands, limits_due(mesh));
  report.quality = summarize_quality(mesh, demands.worst);

  VerifyOptions verify_options;
  if (report.held_to) verify_options.guarantee = guarantee_of(*report.held_to);
  verify_options.delaunay = report.ours;
  if (against != nullptr) hold_against(*against, report.ours, verify_options);
  report.verified = verify(mesh, verify_options, control);
  conclude(report);
  return report;
}

}  // namespace unsliver::cli
