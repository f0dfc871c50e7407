/// \file
/// `unsliver info`: what a surface or mesh file holds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <set>

#include "commands.hpp"
#include "files.hpp"
#include "mesh_report.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/io.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver info part.stl
  unsliver info mesh.vtu --json -)text";

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string file, json;
};

Box3 box_of(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.extend(p);
  return box;
}

Json defects_json(const SurfaceDefects& defects) {
  Json json = Json::object();
  const auto add = [&](const char* name, const Defect& defect) {
    json[name] = {{"count", defect.count}, {"first", defect.first}};
  };
  add("duplicate_points", defects.duplicate_points);
  add("degenerate_triangles", defects.degenerate_triangles);
  add("duplicate_triangles", defects.duplicate_triangles);
  add("boundary_edges", defects.boundary_edges);
  add("non_manifold_edges", defects.non_manifold_edges);
  add("inconsistent_edges", defects.inconsistent_edges);
  add("self_intersections", defects.self_intersections);
  return json;
}

/// What `unsliver mesh` would say of it.
std::vector<std::string> meshing_notes(const TriangleMesh& surface) {
  try {
    const DomainPtr domain = make_surface(surface);
    std::vector<std::string> notes = domain->notes();
    notes.insert(notes.begin(), domain->describe());
    return notes;
  } catch (const Error& error) {
    return {std::string("cannot be meshed: ") + error.what()};
  }
}

Json describe_surface(const std::string& path) {
  const TriangleMesh surface = io::read_surface(path);
  const SurfaceDefects defects = inspect_surface(surface);
  return {{"kind", "surface"},
          {"points", surface.points.size()},
          {"triangles", surface.triangles.size()},
          {"bounds", to_json(box_of(surface.points))},
          {"components", defects.components},
          {"inward_components", defects.inward_components},
          {"signed_volume", defects.signed_volume},
          {"clean", defects.clean()},
          {"self_intersections_complete", defects.self_intersections_complete},
          {"defects", defects_json(defects)},
          {"notes", meshing_notes(surface)}};
}

Json describe_tet_mesh(const std::string& path) {
  const TetMesh mesh = io::read_tet_mesh(path);
  Json json{{"kind", "tetrahedral mesh"},
            {"points", mesh.points.size()},
            {"tets", mesh.tets.size()},
            {"triangles", mesh.triangles.size()},
            {"bounds", to_json(box_of(mesh.points))}};
  json["regions"] = std::set<std::int32_t>(mesh.regions.begin(), mesh.regions.end());
  json["triangle_labels"] = std::set<std::int32_t>(mesh.triangle_labels.begin(), mesh.triangle_labels.end());
  json["lattice_levels"] = !mesh.levels.empty();
  return json;
}

Vec3 point_of(const Json& json) { return {json[0], json[1], json[2]}; }

std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_unsigned()) return with_separators(value.get<std::uint64_t>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.dump();
}

class Rows {
 public:
  void add(std::string name, const std::string& value) {
    std::replace(name.begin(), name.end(), '_', ' ');
    fmt::format_to(std::back_inserter(text_), "  {:<24}{}\n", name, value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What was found in the file, before anything is mended.
void add_defects(Rows& rows, const Json& report) {
  rows.add("clean", report["clean"].get<bool>() ? "yes" : "no; found in the file:");
  for (const auto& [name, defect] : report["defects"].items())
    if (const auto count = defect["count"].get<std::uint64_t>(); count > 0)
      rows.add("- " + name, with_separators(count) + "; the first: " + defect["first"].dump());
  if (!report["self_intersections_complete"].get<bool>())
    rows.add("- self_intersections", "there are more: the search stopped early");
}

/// What meshing makes of it: the domain, and how it came about.
void add_notes(Rows& rows, const Json& notes) {
  for (const auto& note : notes)
    rows.add(note == notes.front() ? "meshed as" : "- note", note.get<std::string>());
}

bool has_own_row(const std::string& name, const Json& value) {
  constexpr std::array kElsewhere = {"unsliver", "command", "exit_code", "clean",
                                     "self_intersections_complete"};
  return std::find(kElsewhere.begin(), kElsewhere.end(), name) == kElsewhere.end() &&
         !(value.is_array() && value.empty());
}

std::string to_text(const Json& report) {
  Rows rows;
  for (const auto& [name, value] : report.items())
    if (name == "bounds")
      rows.add(name, box_text({point_of(value["lo"]), point_of(value["hi"])}));
    else if (name == "defects")
      add_defects(rows, report);
    else if (name == "notes")
      add_notes(rows, value);
    else if (has_own_row(name, value))
      rows.add(name, value_text(value));
  return rows.text();
}

/// \throws Error kBadOption.
void check_is_known(const std::string& path) {
  if (is_surface_file(path) || is_tet_mesh_file(path)) return;
  throw Error(ErrorCode::kBadOption,
              path + ": info reads surfaces (.stl .obj .off .ply) and meshes (.vtu .msh .mesh .node .ele)");
}

ExitCode run(const InfoOptions& options) {
  check_readable(options.file);
  check_is_known(options.file);
  check_distinct({options.json}, {options.file});
  check_report_file(options.json);
  Json json = json_head("info", ExitCode::kDone);
  json["file"] = options.file;
  json.update(is_surface_file(options.file) ? describe_surface(options.file)
                                            : describe_tet_mesh(options.file));
  if (options.json != "-") print_result(to_text(json));
  if (!options.json.empty()) write_json(options.json, json.dump(2) + "\n");
  return ExitCode::kDone;
}

}  // namespace

Command add_info(CLI::App& app) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* const parser =
      app.add_subcommand("info", "Say what a surface or mesh file holds, and its defects");
  parser
      ->add_option("FILE", options->file,
                   "surface (.stl .obj .off .ply) or mesh (.vtu .msh .mesh .node .ele)")
      ->required();
  parser->add_option("--json", options->json, "report for machines: a file, or - for standard output");
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
