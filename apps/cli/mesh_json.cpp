#include "mesh_report.hpp"
#include "resources.hpp"

namespace unsliver::cli {
namespace {

using Json = nlohmann::ordered_json;

Json input_json(const DomainSource& source) {
  Json json{{"kind", source.kind}, {"label", source.label}};
  if (source.surface) {
    json["points"] = source.surface->points.size();
    json["triangles"] = source.surface->triangles.size();
  }
  json["domain"] = source.domain->describe();
  json["bounds"] = to_json(source.domain->bounds());
  json["conform"] = source.exact_box.has_value();
  json["periodic"] = source.periodic_cell.has_value();
  json["notes"] = all_notes(source);
  return json;
}

Json points_json(const MeshReport& report) {
  if (!report.source || !report.source->inputs) return nullptr;
  const InputVertices& inputs = *report.source->inputs;
  return {{"file", inputs.file},
          {"count", inputs.count()},
          {"with_sizes", !inputs.set.sizes.empty()},
          {"notes", inputs.set.notes}};
}

Json before_json(const MeshReport& report) {
  if (!report.source || !report.source->before) return nullptr;
  return {{"vertices", report.source->inputs->count()},
          {"tets", report.source->before->tets},
          {"quality", to_json(*report.source->before)}};
}

Json size_json(const SizeSource& size) {
  Json json{{"description", size.sizing->describe()},
            {"default", size.by_default},
            {"constant", nullptr},
            {"size_per_edge_length", kSizePerEdge},
            {"notes", size.sizing->notes()}};
  if (size.constant) json["constant"] = *size.constant;
  return json;
}

Json options_json(const MeshOptions& options) {
  return {{"strategy", to_string(options.strategy)},
          {"min_dihedral_deg", options.min_dihedral_deg},
          {"max_dihedral_deg", options.max_dihedral_deg},
          {"max_radius_edge", options.max_radius_edge},
          {"max_tets", options.max_tets},
          {"max_memory_bytes", options.max_memory_bytes},
          {"threads", options.threads}};
}

Json estimate_json(const SizeEstimate& estimate) {
  return {{"vertices", estimate.vertices},
          {"tets", estimate.tets},
          {"bytes", estimate.bytes},
          {"ideal_vertices", estimate.ideal_vertices}};
}

Json subcases_json(const MeshStats& stats) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kSubcaseNames.size(); ++i) json[kSubcaseNames[i]] = stats.figure_8[i];
  return json;
}

Json stats_json(const MeshStats& stats) {
  return {{"strategy", to_string(stats.strategy)},
          {"strategy_reason", stats.strategy_reason},
          {"threads", stats.threads},
          {"size_insertions", stats.size_insertions},
          {"quality_insertions", stats.quality_insertions},
          {"lemma_6_insertions", stats.lemma_6_insertions},
          {"figure_8", subcases_json(stats)},
          {"candidates", stats.candidates},
          {"total_vertices", stats.total_vertices},
          {"total_tets", stats.total_tets},
          {"peak_bytes", stats.peak_bytes},
          {"insphere",
           {{"filter", stats.insphere_filter},
            {"small", stats.insphere_small},
            {"wide", stats.insphere_wide},
            {"tie", stats.insphere_tie}}},
          {"orient",
           {{"filter", stats.orient_filter}, {"small", stats.orient_small}, {"wide", stats.orient_wide}}},
          {"domain_tests", stats.domain_tests}};
}

Json worst_json(const WorstTet& worst) {
  Json corners = Json::array();
  for (const Vec3& p : worst.corners) corners.push_back(to_json(p));
  return {{"tet", worst.tet},
          {"min_dihedral_deg", worst.min_dihedral_deg},
          {"max_dihedral_deg", worst.max_dihedral_deg},
          {"radius_edge", worst.radius_edge},
          {"corners", corners}};
}

Json time_json(const MeshReport& report) {
  Json phases = Json::array();
  for (const PhaseTime& phase : report.phases)
    phases.push_back({{"name", phase.name}, {"seconds", phase.seconds}});
  return {{"phases", phases}, {"total_seconds", report.total_seconds}};
}

template <typename T, typename Convert>
Json optional_json(const std::optional<T>& value, Convert convert) {
  return value ? convert(*value) : Json(nullptr);
}

}  // namespace

Json to_json(const Vec3& p) { return Json::array({p.x, p.y, p.z}); }
Json to_json(const Box3& box) { return {{"lo", to_json(box.lo)}, {"hi", to_json(box.hi)}}; }

Json to_json(const QualitySummary& quality) {
  Json worst = Json::array();
  for (const WorstTet& tet : quality.worst) worst.push_back(worst_json(tet));
  const auto& below = quality.below;
  return {{"min_dihedral_deg", quality.min_dihedral_deg},
          {"max_dihedral_deg", quality.max_dihedral_deg},
          {"max_radius_edge", quality.max_radius_edge},
          {"volume", quality.volume},
          {"inverted", quality.inverted},
          {"flat", quality.flat},
          {"tets_below_deg",
           {{"5", below[0]}, {"10", below[1]}, {"15", below[2]}, {"20", below[3]}, {"30", below[4]}}},
          {"tets_outside_30_135", quality.outside_30_135},
          {"dihedral_histogram_5_deg", quality.histogram},
          {"worst", worst}};
}

Json to_json(const VerifyReport& verified) {
  Json findings = Json::array();
  for (const Finding& finding : verified.findings)
    findings.push_back({{"check", finding.check}, {"message", finding.message}, {"ids", finding.ids}});
  return {{"ok", verified.ok},
          {"finding_count", verified.finding_count},
          {"findings", findings},
          {"checks", verified.checks},
          {"exact_decisions", verified.exact_decisions},
          {"filtered_decisions", verified.filtered_decisions},
          {"min_dihedral_deg", verified.min_dihedral_deg},
          {"max_dihedral_deg", verified.max_dihedral_deg},
          {"max_radius_edge", verified.max_radius_edge},
          {"volume", verified.volume},
          {"worst_size_ratio", verified.worst_size_ratio}};
}

Json to_json(const Error& error) {
  Json places = Json::array();
  for (const Vec3& place : error.places) places.push_back(to_json(place));
  return {
      {"code", to_string(error.code())}, {"message", error.what()}, {"ids", error.ids}, {"places", places}};
}

Json json_head(const std::string& command, ExitCode exit_code) {
  return {{"unsliver", UNSLIVER_VERSION}, {"command", command}, {"exit_code", static_cast<int>(exit_code)}};
}

Json to_json(const MeshReport& report) {
  Json json = json_head(report.command, report.exit_code);
  const auto plain = [](const auto& value) { return to_json(value); };
  json["status"] = report.status;
  json["guaranteed"] = report.guaranteed();
  json["verified"] = report.is_verified();
  json["output"] = report.output.empty() ? Json(nullptr) : Json(report.output);
  json["input"] = optional_json(report.source, input_json);
  json["points"] = points_json(report);
  json["before"] = before_json(report);
  json["size"] = optional_json(report.size, size_json);
  json["options"] = optional_json(report.options, options_json);
  json["estimate"] = optional_json(report.estimate, estimate_json);
  json["mesh"] = optional_json(report.counts, [](const MeshCounts& counts) {
    return Json{{"vertices", counts.vertices},
                {"input_vertices", counts.input_vertices},
                {"tets", counts.tets},
                {"boundary_triangles", counts.boundary_triangles}};
  });
  json["quality"] = optional_json(report.quality, plain);
  json["verify"] = optional_json(report.verified, plain);
  json["notes"] = report.notes;
  json["stats"] = optional_json(report.stats, stats_json);
  json["time"] = time_json(report);
  json["memory"] = {{"peak_resident_bytes", peak_resident_memory()}};
  json["error"] = optional_json(report.error, plain);
  return json;
}

}  // namespace unsliver::cli
