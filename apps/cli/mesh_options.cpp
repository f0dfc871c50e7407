#include "mesh_options.hpp"

#include <fmt/format.h>

#include "files.hpp"
#include "generator_options.hpp"
#include "raw_mesh.hpp"
#include "text.hpp"
#include "unsliver/error.hpp"
#include "usage.hpp"

namespace unsliver::cli {
namespace {

void add_domain_options(CLI::App& parser, DomainRequest& domain) {
  parser.add_option("INPUT", domain.surface_file, "surface file: .stl .obj .off .ply");
  parser.add_option("--box", domain.box, "\"x0 y0 z0 x1 y1 z1\": mesh a box")->group("What to mesh (one)");
  parser
      .add_flag("--conform", domain.conform,
                "with --box: fill it exactly, with flat faces, marked 1 to 6\n"
                "(x low, x high, y low, ...). Its sides must be whole multiples\n"
                "of one length m * 2^e, m < 128. Strategy octree, no points")
      ->group("What to mesh (one)");
  parser
      .add_flag("--periodic", domain.periodic,
                "with --box: its opposite faces are one, there is no boundary.\n"
                "The same boxes as with --conform; points may lie anywhere and\n"
                "are moved into the cell, with strategy thrifty or literal")
      ->group("What to mesh (one)");
  parser.add_option("--ball", domain.ball, "\"cx cy cz r\": mesh a ball")->group("What to mesh (one)");
  parser.add_option("--implicit", domain.implicit, "formula f(x, y, z): mesh where f <= 0")
      ->group("What to mesh (one)");
  parser.add_option("--bounds", domain.bounds, "\"x0 y0 z0 x1 y1 z1\": where to look, with --implicit")
      ->group("What to mesh (one)");
  parser
      .add_option("--points", domain.points_file,
                  "points that become vertices of the mesh: .xyz .csv .pqr .node,\n"
                  "or the vertices of any surface or mesh file. With one of the\n"
                  "above, or alone: the points' bounding box is meshed. A size\n"
                  "at each point: radii of .pqr, or in .csv a column size, radius\n"
                  "or s, or the 4th where no header names them; .xyz has none")
      ->group("What to mesh (one)");
  parser
      .add_flag("--hull", domain.hull, "with --points alone: mesh their convex hull, not the box around it")
      ->group("What to mesh (one)");
}

void add_size_options(CLI::App& parser, SizeRequest& size) {
  const std::string group = "How fine (several combine by minimum)";
  parser
      .add_option("--size", size.size,
                  "length or formula s(x, y, z), a ball radius: every ball\n"
                  "B(p, s(p)) about a point of the domain holds a vertex.\n"
                  "Default: 1/40 of the diagonal of the box around the surface,\n"
                  "of --box, around the ball, or of --bounds; with points and\n"
                  "for refine none")
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
                  fmt::format("g: constant sizes grow away from the surface as\n"
                              "s + g * distance, without one from the points; the\n"
                              "sizes of points likewise (default {}); formulas and\n"
                              "size meshes are lowered where they change faster",
                              kDefaultGradation))
      ->group(group);
  parser
      .add_option("--size-max", size.size_max, "cap of the size that grows away from the surface or points")
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
                  "circumradius / shortest edge: at least sqrt(5)/2, with\n"
                  "points 1.368 (the defaults)")
      ->group(group);
  parser
      .add_option("--strategy", options.strategy,
                  "how the mesh is made, see the table below. Default: auto, which\n"
                  "chooses and says why")
      ->check(one_of({"auto", "thrifty", "literal", "closure", "octree"}))
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

/// More help nobody: a number typed by mistake should not start a million of them.
constexpr unsigned kMostThreads = 1024;

void add_thread_option(CLI::App& parser, MeshCommandOptions& options) {
  parser
      .add_option("--threads", options.threads,
                  "of strategy octree: the same mesh for every number.\n"
                  "Default: one for each core. The other strategies use one")
      ->check(CLI::Range(1u, kMostThreads));
}

void add_output_options(CLI::App& parser, MeshCommandOptions& options) {
  parser.add_option("-o,--output", options.output, "mesh file: .vtu .msh .mesh .node");
  add_write_options(parser, options.write);
  parser.add_option("--json", options.json, "report for machines: a file, or - for standard output");
  parser.add_flag("--quiet", options.quiet, "print errors only");
}

void add_shared_options(CLI::App& parser, MeshCommandOptions& options) {
  add_output_options(parser, options);
  add_size_options(parser, options.size);
  add_quality_options(parser, options);
  add_limit_options(parser, options);
  add_thread_option(parser, options);
}

void check_periodic_run(const MeshCommandOptions& options) {
  if (!options.domain.periodic) {
    if (!options.topology.empty())
      throw Error(ErrorCode::kBadOption, "--topology has no effect without --periodic");
    return;
  }
  if (options.strategy == "octree" && options.domain.has_inputs())
    throw Error(ErrorCode::kBadOption,
                "--strategy octree knows no points in periodic cells: use thrifty or literal");
}

/// Pieces are made, and the judge for them knows, what octrees make around a domain, and no more.
void check_stream(const MeshCommandOptions& options) {
  const auto refuse = [](const std::string& what) {
    throw Error(ErrorCode::kBadOption, "--stream writes a folder of plain arrays: " + what);
  };
  if (!options.output.empty()) refuse("leave out --output");
  if (!options.write.format.empty() || options.write.ascii) refuse("--format and --ascii have no effect");
  if (options.domain.has_inputs()) refuse("it goes without points");
  if (options.domain.conform) refuse("it goes without --conform");
  if (options.domain.periodic) refuse("it goes without --periodic");
  if (options.keep_partial) refuse("--keep-partial has no effect, there is no mesh until its end");
  if (options.strategy != "auto" && options.strategy != "octree")
    refuse("it goes with --strategy octree, not " + options.strategy);
  check_raw_output(options.stream);
}

void check_output(const MeshCommandOptions& options) {
  if (!options.stream.empty()) return check_stream(options);
  if (options.output.empty())
    throw Error(ErrorCode::kBadOption, options.domain.mesh_file
                                           ? "--output is required: the mesh file to write"
                                           : "--output is required: the mesh file to write, or --stream");
  check_write_options(options.output, options.write);
}

}  // namespace

void add_write_options(CLI::App& parser, io::WriteOptions& write) {
  parser.add_option("--format", write.format, "vtu, msh22, msh41, medit or tetgen; default: by extension")
      ->check(one_of({"vtu", "msh22", "msh41", "medit", "tetgen"}));
  parser.add_flag("--ascii", write.ascii, "text instead of binary, for Gmsh files");
}

void check_write_options(const std::string& output, const io::WriteOptions& write) {
  check_mesh_output(output, write.format);
  const bool gmsh = write.format.empty() ? extension_of(output) == "msh" : write.format.starts_with("msh");
  if (write.ascii && !gmsh) throw Error(ErrorCode::kBadOption, "--ascii has no effect except on Gmsh files");
}

void add_mesh_options(CLI::App& parser, MeshCommandOptions& options) {
  add_domain_options(parser, options.domain);
  add_shared_options(parser, options);
  parser.add_option("--topology", options.topology,
                    "with --periodic: a JSON file of the vertices, the tetrahedra by\n"
                    "vertices and periods, and which points are copies of which");
  parser.add_option("--stream", options.stream,
                    "in place of --output, for meshes larger than memory: a new\n"
                    "folder of plain arrays. Strategy octree, no points, no --conform");
}

void add_refine_options(CLI::App& parser, MeshCommandOptions& options) {
  parser.add_option("MESH", options.domain.mesh_file, "mesh file: .vtu .msh .mesh .node .ele")->required();
  add_shared_options(parser, options);
}

void check_mesh_files(const MeshCommandOptions& options) {
  std::vector<std::string> read;
  for (const auto* path : {&options.domain.surface_file, &options.domain.mesh_file,
                           &options.domain.points_file, &options.size.size_mesh})
    read.push_back(path->value_or(""));
  check_distinct({options.output, options.json, options.topology}, read);
  check_report_file(options.json);
}

void check_mesh_options(MeshCommandOptions& options) {
  check_domain_request(options.domain);
  check_size_request(options.size);
  check_angles(options.mesh);
  options.mesh.max_radius_edge = radius_edge_bound(options.max_radius_edge, options.domain.has_inputs());
  check_periodic_run(options);
  options.mesh.strategy = strategy_of(
      options.strategy, {options.keep_partial, options.domain.has_inputs(), options.domain.conform});
  options.mesh.threads = options.threads.value_or(0);
  if (!options.max_tets.empty()) options.mesh.max_tets = parse_count(options.max_tets, "--max-tets");
  if (!options.max_memory.empty())
    options.mesh.max_memory_bytes = parse_bytes(options.max_memory, "--max-memory");
  check_output(options);
}

}  // namespace unsliver::cli
