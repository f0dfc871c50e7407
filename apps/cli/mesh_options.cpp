#include "mesh_options.hpp"

#include <fmt/format.h>

#include "files.hpp"
#include "text.hpp"
#include "unsliver/error.hpp"

namespace unsliver::cli {
namespace {

void add_domain_options(CLI::App& parser, DomainRequest& domain) {
  parser.add_option("INPUT", domain.surface_file, "surface file: .stl .obj .off .ply");
  parser.add_option("--box", domain.box, "\"x0 y0 z0 x1 y1 z1\": mesh a box")->group("What to mesh (one)");
  parser.add_option("--ball", domain.ball, "\"cx cy cz r\": mesh a ball")->group("What to mesh (one)");
  parser.add_option("--implicit", domain.implicit, "formula f(x, y, z): mesh where f <= 0")
      ->group("What to mesh (one)");
  parser.add_option("--bounds", domain.bounds, "\"x0 y0 z0 x1 y1 z1\": where to look, with --implicit")
      ->group("What to mesh (one)");
}

void add_size_options(CLI::App& parser, SizeRequest& size) {
  const std::string group = "How fine (several combine by minimum)";
  parser
      .add_option("--size", size.size,
                  "length or formula s(x, y, z), a ball radius: every ball\n"
                  "B(p, s(p)) about a point of the domain holds a vertex.\n"
                  "Default: diagonal of the domain / 40")
      ->group(group);
  parser
      .add_option("--edge-length", size.edge_length,
                  fmt::format("length or formula: the mean edge of the lattice that fits;\n"
                              "the same as --size {:.5f} * (edge length)",
                              kSizePerEdge))
      ->group(group);
  parser
      .add_option("--size-mesh", size.size_mesh,
                  "file of nodal values of s: .mesh with .sol beside it,\n"
                  "or .node and .ele with .mtr beside them")
      ->group(group);
  parser
      .add_option("--size-gradation", size.gradation,
                  "g: constant sizes grow away from the surface as\n"
                  "s + g * distance; formulas and size meshes are lowered\n"
                  "where they change faster than g")
      ->group(group);
  parser.add_option("--size-max", size.size_max, "cap of the size that grows away from the surface")
      ->group(group);
}

void add_quality_options(CLI::App& parser, MeshCommandOptions& options) {
  const std::string group = "How good";
  parser
      .add_option("--min-angle", options.mesh.min_dihedral_deg,
                  "smallest dihedral angle, at most 30 (the default)")
      ->group(group);
  parser
      .add_option("--max-angle", options.mesh.max_dihedral_deg,
                  "largest dihedral angle, at least 135 (the default)")
      ->group(group);
  parser
      .add_option("--max-radius-edge", options.max_radius_edge,
                  "circumradius / shortest edge, at least sqrt(5)/2 (the default)")
      ->group(group);
  parser
      .add_option("--strategy", options.strategy,
                  "thrifty (default: fewer vertices) or literal (the paper's\nfigure to the letter)")
      ->check(CLI::IsMember({"thrifty", "literal"}))
      ->group(group);
  parser.add_flag("--no-verify", options.no_verify, "skip the independent exact check at the end")
      ->group(group);
}

void add_limit_options(CLI::App& parser, MeshCommandOptions& options) {
  const std::string group = "Limits";
  parser.add_option("--max-tets", options.max_tets, "most tetrahedra held at any time, such as 500k or 20M")
      ->group(group);
  parser
      .add_option("--max-memory", options.max_memory,
                  "most bytes held by the generator, such as 500M or 8G.\n"
                  "Default: the memory available now")
      ->group(group);
  parser
      .add_flag("--keep-partial", options.keep_partial,
                "write the valid mesh so far when a limit or Ctrl-C ends the run")
      ->group(group);
}

void add_output_options(CLI::App& parser, MeshCommandOptions& options) {
  parser.add_option("-o,--output", options.output, "mesh file: .vtu .msh .mesh .node")->required();
  add_write_options(parser, options.write);
  parser.add_option("--json", options.json, "report for machines: a file, or - for standard output");
  parser.add_flag("--quiet", options.quiet, "print errors only");
}

/// `value` must lie between `loosest` and `strictest`, in either order; NaN does not.
void check_bound(const char* option, double value, double strictest, double loosest) {
  const double low = std::min(strictest, loosest), high = std::max(strictest, loosest);
  if (low <= value && value <= high && value != loosest) return;
  throw Error(ErrorCode::kBadOption,
              fmt::format("{} is {}: it must lie between {} and {} ({} is the strictest that is proven)",
                          option, value, low, high, strictest));
}

void check_angles(const MeshOptions& mesh) {
  const MeshOptions proven;
  check_bound("--min-angle", mesh.min_dihedral_deg, proven.min_dihedral_deg, 0);
  check_bound("--max-angle", mesh.max_dihedral_deg, proven.max_dihedral_deg, 180);
}

/// The bound to use, the least that is proven where none was typed.
double radius_edge_bound(const std::optional<double>& typed) {
  const double least = least_radius_edge(false);
  if (!typed || *typed >= least) return typed.value_or(least);
  throw Error(ErrorCode::kBadOption,
              fmt::format("--max-radius-edge is {}: no less than {} (sqrt(5)/2) is proven", *typed, least));
}

}  // namespace

void add_write_options(CLI::App& parser, io::WriteOptions& write) {
  parser.add_option("--format", write.format, "vtu, msh22, msh41, medit or tetgen; default: by extension")
      ->check(CLI::IsMember({"vtu", "msh22", "msh41", "medit", "tetgen"}));
  parser.add_flag("--ascii", write.ascii, "text instead of binary, for Gmsh files");
}

void check_write_options(const std::string& output, const io::WriteOptions& write) {
  check_mesh_output(output, write.format);
  const bool gmsh = write.format.empty() ? extension_of(output) == "msh" : write.format.starts_with("msh");
  if (write.ascii && !gmsh) throw Error(ErrorCode::kBadOption, "--ascii has no effect except on Gmsh files");
}

void add_mesh_options(CLI::App& parser, MeshCommandOptions& options) {
  add_domain_options(parser, options.domain);
  add_output_options(parser, options);
  add_size_options(parser, options.size);
  add_quality_options(parser, options);
  add_limit_options(parser, options);
}

void check_mesh_files(const MeshCommandOptions& options) {
  check_distinct({options.output, options.json},
                 {options.domain.surface_file.value_or(""), options.size.size_mesh.value_or("")});
  if (!options.json.empty() && options.json != "-") check_writable(options.json, "--json");
}

void check_mesh_options(MeshCommandOptions& options) {
  check_domain_request(options.domain);
  check_size_request(options.size, options.domain.surface_file.has_value());
  check_angles(options.mesh);
  options.mesh.max_radius_edge = radius_edge_bound(options.max_radius_edge);
  if (options.strategy == "literal") options.mesh.strategy = Strategy::kLiteral;
  if (!options.max_tets.empty()) options.mesh.max_tets = parse_count(options.max_tets, "--max-tets");
  if (!options.max_memory.empty())
    options.mesh.max_memory_bytes = parse_bytes(options.max_memory, "--max-memory");
  check_write_options(options.output, options.write);
}

}  // namespace unsliver::cli
