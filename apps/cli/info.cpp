/// \file
/// `unsliver info`: what a surface or mesh file holds.
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <set>

#include "commands.hpp"
#include "files.hpp"
#include "mesh_report.hpp"
#include "terminal.hpp"
#include "text.hpp"
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

Json describe_surface(const std::string& path) {
  TriangleMesh surface = io::read_surface(path);
  Json json{{"kind", "surface"},
            {"points", surface.points.size()},
            {"triangles", surface.triangles.size()},
            {"bounds", to_json(box_of(surface.points))}};
  const DomainPtr domain = make_surface(std::move(surface));
  json["domain"] = domain->describe();
  json["volume"] = domain->volume();
  json["notes"] = domain->notes();
  return json;
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

std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_unsigned()) return with_separators(value.get<std::uint64_t>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.dump();
}

std::string to_text(const Json& report) {
  std::string text;
  const auto row = [&](const std::string& name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "  {:<16}{}\n", name, value);
  };
  for (const auto& [name, value] : report.items()) {
    if (name == "unsliver" || name == "command" || name == "exit_code") continue;
    if (name == "bounds")
      row(name, fmt::format("{} to {}", value["lo"].dump(), value["hi"].dump()));
    else if (name == "notes")
      for (const auto& note : value) row("note", note.get<std::string>());
    else if (!value.is_array() || !value.empty())
      row(name, value_text(value));
  }
  return text;
}

ExitCode run(const InfoOptions& options) {
  check_readable(options.file);
  if (!options.json.empty() && options.json != "-") check_writable(options.json, "--json");
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
