#include "check_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mesh_report.hpp"
#include "text.hpp"

namespace unsliver::cli {
namespace {

constexpr int kBarWidth = 50;
constexpr std::size_t kBinDegrees = 5;

template <typename... Args>
void line(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  text += '\n';
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void counts(std::string& text, const CheckReport& report) {
  const QualitySummary& quality = report.quality;
  line(text, "  mesh           {}", report.file);
  line(text, "  vertices       {}", with_separators(report.vertices));
  line(text, "  tetrahedra     {}", with_separators(quality.tets));
  line(text, "  bounds         {}", box_text(report.bounds));
  line(text, "  volume         {:.10g}", quality.volume);
  if (quality.inverted > 0) line(text, "  inverted       {}", with_separators(quality.inverted));
  if (quality.flat > 0) line(text, "  flat           {}", with_separators(quality.flat));
}

/// The bins between the first and the last that hold an angle.
void histogram(std::string& text, const QualitySummary& quality) {
  const auto& bins = quality.histogram;
  const auto filled = [](std::uint64_t n) { return n > 0; };
  const auto first = std::find_if(bins.begin(), bins.end(), filled);
  const auto last = std::find_if(bins.rbegin(), bins.rend(), filled).base();
  const std::uint64_t most = *std::max_element(bins.begin(), bins.end());
  line(text, "\n  Dihedral angles (degrees, six a tetrahedron)");
  for (auto bin = first; bin < last; ++bin) {
    const std::size_t degrees = kBinDegrees * static_cast<std::size_t>(bin - bins.begin());
    const auto length = static_cast<std::size_t>(percent(*bin, most) / 100 * kBarWidth + 0.999);
    line(text, "  {:>3} - {:<3} {:>13} {}", degrees, degrees + kBinDegrees, with_separators(*bin),
         std::string(length, '#'));
  }
}

void extremes(std::string& text, const QualitySummary& quality) {
  line(text, "\n  dihedral angles {:.3f} to {:.3f} degrees, largest radius-edge ratio {}",
       quality.min_dihedral_deg, quality.max_dihedral_deg, ratio_text(quality.max_radius_edge));
  constexpr std::array kLimits = {5, 10, 15, 20, 30};
  for (std::size_t i = 0; i < kLimits.size(); ++i)
    line(text, "  below {:>2} degrees     {:>12}  {:6.2f} %", kLimits[i], with_separators(quality.below[i]),
         percent(quality.below[i], quality.tets));
  line(text, "  outside [30, 135]   {:>12}  {:6.2f} %", with_separators(quality.outside_30_135),
       percent(quality.outside_30_135, quality.tets));
}

void worst(std::string& text, const QualitySummary& quality) {
  if (quality.worst.empty()) return;
  line(text, "\n  Smallest dihedral angles");
  for (const WorstTet& tet : quality.worst) {
    line(text, "  tetrahedron {:<9} angles {:.3f} to {:.3f}, radius-edge {}", tet.tet, tet.min_dihedral_deg,
         tet.max_dihedral_deg, ratio_text(tet.radius_edge));
    line(text, "    {} {} {} {}", point_text(tet.corners[0]), point_text(tet.corners[1]),
         point_text(tet.corners[2]), point_text(tet.corners[3]));
  }
}

/// Those that limit anything.
std::string held_to_text(const QualityLimits& limits) {
  std::vector<std::string> texts;
  if (limits.min_dihedral_deg > 0)
    texts.push_back(fmt::format("dihedral angles of {:.6g} degrees or more", limits.min_dihedral_deg));
  if (limits.max_dihedral_deg < 180)
    texts.push_back(fmt::format("dihedral angles of {:.6g} degrees or less", limits.max_dihedral_deg));
  if (std::isfinite(limits.max_radius_edge))
    texts.push_back(fmt::format("radius-edge ratios of {:.6g} or less", limits.max_radius_edge));
  return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, ", "));
}

void verdict(std::string& text, const CheckReport& report) {
  line(text, "\n  Checked{}", report.ours ? " (a mesh of unsliver: its guarantees are due)" : "");
  if (report.held_to) line(text, "    held to: {}", held_to_text(*report.held_to));
  for (const std::string& check : report.verified.checks) line(text, "    {}", check);
  for (const Finding& finding : report.verified.findings)
    line(text, "  FAULT {}: {}", finding.check, finding.message);
  if (report.verified.ok)
    line(text, "  verdict        no fault found");
  else
    line(text, "  verdict        {}", plural(report.verified.finding_count, "finding"));
}

}  // namespace

std::string to_table(const CheckReport& report) {
  std::string text;
  counts(text, report);
  if (report.quality.tets > 0) {
    histogram(text, report.quality);
    extremes(text, report.quality);
    worst(text, report.quality);
  }
  verdict(text, report);
  return text;
}

namespace {

/// What limits nothing is null.
nlohmann::ordered_json to_json(const QualityLimits& limits) {
  const auto unless = [](bool idle, double value) {
    return idle ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(value);
  };
  return {{"min_dihedral_deg", unless(limits.min_dihedral_deg <= 0, limits.min_dihedral_deg)},
          {"max_dihedral_deg", unless(limits.max_dihedral_deg >= 180, limits.max_dihedral_deg)},
          {"max_radius_edge", unless(!std::isfinite(limits.max_radius_edge), limits.max_radius_edge)}};
}

}  // namespace

nlohmann::ordered_json to_json(const CheckReport& report) {
  nlohmann::ordered_json json = json_head("check", report.exit_code);
  json["file"] = report.file;
  json["against"] =
      report.against.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(report.against);
  json["vertices"] = report.vertices;
  json["tets"] = report.quality.tets;
  json["bounds"] = to_json(report.bounds);
  json["ours"] = report.ours;
  json["held_to"] = nullptr;
  if (report.held_to) json["held_to"] = to_json(*report.held_to);
  json["quality"] = to_json(report.quality);
  json["verify"] = to_json(report.verified);
  return json;
}

}  // namespace unsliver::cli
