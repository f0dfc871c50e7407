#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

#include "mesh_report.hpp"
#include "resources.hpp"
#include "text.hpp"

namespace unsliver::cli {
namespace {

class Table {
 public:
  void row(const std::string& name, const std::string& text) {
    fmt::format_to(std::back_inserter(text_), "  {:<13}{}\n", name, text);
  }
  void compare(const std::string& name, const std::string& asked, const std::string& guaranteed,
               const std::string& achieved) {
    fmt::format_to(std::back_inserter(text_), "  {:<18}{:>12}{:>14}{:>14}\n", name, asked, guaranteed,
                   achieved);
  }
  void change(const std::string& name, const std::string& before, const std::string& after) {
    fmt::format_to(std::back_inserter(text_), "  {:<18}{:>12}{:>14}\n", name, before, after);
  }
  void blank() { text_ += '\n'; }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void notes(Table& table, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) table.row("", "note: " + line);
}

void points(Table& table, const InputVertices& inputs) {
  table.row("points", with_separators(inputs.count()) + " from " + inputs.file +
                          (inputs.set.sizes.empty() ? "" : ", with sizes"));
  notes(table, inputs.set.notes);
}

void job(Table& table, const MeshReport& report) {
  if (report.source) {
    table.row("input", report.source->label);
    table.row("domain", report.source->domain->describe());
    notes(table, all_notes(*report.source));
    if (report.source->inputs) points(table, *report.source->inputs);
  }
  if (report.size) {
    const bool default_constant = report.size->by_default && report.size->constant;
    table.row("size s",
              report.size->sizing->describe() + (default_constant ? " (default: diagonal / 40)" : ""));
    if (report.size->constant)
      table.row("", fmt::format("edges about {:.4g} on average (s = {:.5f} edge)",
                                *report.size->constant / kSizePerEdge, kSizePerEdge));
    notes(table, report.size->sizing->notes());
  }
  if (report.counts) {
    table.row("vertices", with_separators(report.counts->vertices));
    table.row("tetrahedra", with_separators(report.counts->tets));
  }
}

/// What `unsliver refine` is for.
void slivers(Table& table, const MeshReport& report) {
  if (!report.source || !report.source->before || !report.quality) return;
  const QualitySummary &before = *report.source->before, &after = *report.quality;
  const std::size_t vertices_before = report.source->inputs->count();
  table.blank();
  table.change("", "before", "after");
  table.change("vertices", with_separators(vertices_before), with_separators(report.counts->vertices));
  table.change("tetrahedra", with_separators(before.tets), with_separators(after.tets));
  constexpr std::array kLimits = {5, 10, 15, 20, 30};
  for (std::size_t i = 0; i < kLimits.size(); ++i)
    table.change(fmt::format("below {} deg", kLimits[i]), with_separators(before.below[i]),
                 with_separators(after.below[i]));
  table.change("growth", "",
               fmt::format("{:.1f} times", static_cast<double>(report.counts->vertices) /
                                               static_cast<double>(vertices_before)));
}

struct Achieved {
  double min_dihedral_deg, max_dihedral_deg, radius_edge;
};

/// By the verifier where it ran, in doubles otherwise.
Achieved achieved(const MeshReport& report) {
  if (report.verified)
    return {report.verified->min_dihedral_deg, report.verified->max_dihedral_deg,
            report.verified->max_radius_edge};
  return {report.quality->min_dihedral_deg, report.quality->max_dihedral_deg,
          report.quality->max_radius_edge};
}

std::string degrees(double angle) { return fmt::format("{:.2f} deg", angle); }

/// What is promised where `asked` was asked for. Without verification nobody has seen the promise kept.
std::string promise(const MeshReport& report, const std::string& asked) {
  if (!report.guaranteed()) return "none";
  return report.is_verified() ? asked : "not verified";
}

void comparison(Table& table, const MeshReport& report) {
  if (!report.quality || report.quality->tets == 0) return;
  const Achieved got = achieved(report);
  const auto compare = [&](const char* name, const std::string& asked, const std::string& value) {
    table.compare(name, asked, promise(report, asked), value);
  };
  table.blank();
  table.compare("", "asked", "guaranteed", report.verified ? "achieved" : "measured");
  compare("smallest angle", degrees(report.options->min_dihedral_deg), degrees(got.min_dihedral_deg));
  compare("largest angle", degrees(report.options->max_dihedral_deg), degrees(got.max_dihedral_deg));
  compare("radius-edge", ratio_text(report.options->max_radius_edge), ratio_text(got.radius_edge));
  if (report.verified && report.verified->worst_size_ratio > 0)
    compare("size ratio", ratio_text(1), ratio_text(report.verified->worst_size_ratio));
  table.blank();
}

void costs(Table& table, const MeshReport& report) {
  std::string times;
  for (const PhaseTime& phase : report.phases)
    times += fmt::format("{} {}, ", phase.name, human_seconds(phase.seconds));
  table.row("time", times + "total " + human_seconds(report.total_seconds));
  std::string memory = human_bytes(static_cast<double>(peak_resident_memory())) + " at most";
  if (report.stats && report.stats->total_tets > 0)
    memory += fmt::format(
        ", generator {} ({:.0f} bytes a tetrahedron)",
        human_bytes(static_cast<double>(report.stats->peak_bytes)),
        static_cast<double>(report.stats->peak_bytes) / static_cast<double>(report.stats->total_tets));
  table.row("memory", memory);
}

std::string unverified(const MeshReport& report) {
  if (report.status == "unverified" || report.status == "cancelled") return "no: interrupted";
  return report.counts && report.counts->tets == 0 ? "no: there is no mesh yet"
                                                   : "no: switched off by --no-verify";
}

std::string strategy(const MeshStats& stats) {
  return fmt::format("{} ({}), {}", to_string(stats.strategy), stats.strategy_reason,
                     plural(stats.threads, "thread"));
}

std::string verdict(const MeshReport& report) {
  if (!report.verified) return unverified(report);
  if (!report.verified->ok)
    return fmt::format("FAILED: {}", plural(report.verified->finding_count, "finding"));
  return fmt::format("yes, exactly, by {}", plural(report.verified->checks.size(), "independent check"));
}

}  // namespace

std::string ratio_text(double ratio) {
  return std::isfinite(ratio) ? fmt::format("{:.4f}", ratio) : "unbounded";
}

std::string to_table(const MeshReport& report) {
  Table table;
  job(table, report);
  slivers(table, report);
  comparison(table, report);
  if (report.stats) table.row("strategy", strategy(*report.stats));
  table.row("verified", verdict(report));
  notes(table, report.notes);
  costs(table, report);
  table.row("status", report.status);
  table.row("written", report.output.empty() ? "nothing" : report.output);
  return std::move(table).text();
}

}  // namespace unsliver::cli
