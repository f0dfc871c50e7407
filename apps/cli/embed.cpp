/// \file
/// `unsliver embed`: where the vertices of a surface lie in a mesh.
#include "unsliver/embed.hpp"

#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "files.hpp"
#include "interrupts.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "unsliver/io.hpp"
#include "unsliver/io_arrays.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver mesh bunny.stl -o bunny.vtu --size 0.1
  unsliver embed bunny.stl bunny.vtu -o rig.npz
  unsliver embed bunny.stl bunny.vtu -o rig.vtu
For each vertex of SURFACE the tetrahedron of MESH that holds it: arrays tets (its index), vertices (its four
corners) and weights (barycentric coordinates, not negative, of sum 1). When the mesh is deformed, vertex i of
the surface moves to the sum over k of weights[i, k] times the place of mesh vertex vertices[i, k]. In .npz
files (numpy) the surface's points and triangles are arrays as well; in .vtu files (ParaView) they are the
geometry and the rest is point data. Corners of .stl files that are equal bit for bit are one vertex.)text";

struct EmbedOptions {
  std::string surface, mesh, output;
  bool quiet = false;
};

template <typename T, std::size_t kColumns, typename Row>
io::NamedArray named(const std::string& name, const std::vector<Row>& rows) {
  static_assert(sizeof(Row) == kColumns * sizeof(T));
  return {name, kColumns,
          std::span<const T>(reinterpret_cast<const T*>(rows.data()), kColumns * rows.size())};
}

void write(const std::string& path, const TriangleMesh& surface, const Embedding& embedding) {
  std::vector<io::NamedArray> arrays = {named<std::int64_t, 1>("tets", embedding.tets),
                                        named<std::int64_t, 4>("vertices", embedding.vertices),
                                        named<double, 4>("weights", embedding.weights)};
  const interrupts::Hold hold(interrupts::Hold::For::kFile);
  if (extension_of(path) == "vtu") return io::write_surface_vtu(path, surface, arrays);
  std::vector<std::array<std::int64_t, 3>> triangles;
  for (const auto& [a, b, c] : surface.triangles) triangles.push_back({a, b, c});
  arrays.push_back(named<double, 3>("points", surface.points));
  arrays.push_back(named<std::int64_t, 3>("triangles", triangles));
  io::write_npz(path, arrays);
}

void check_files(const EmbedOptions& options) {
  const std::string extension = extension_of(options.output);
  if (extension != "npz" && extension != "vtu")
    throw Error(ErrorCode::kBadOption,
                options.output + ": use .npz (numpy) or .vtu (ParaView) for the output");
  check_readable(options.surface);
  check_readable(options.mesh);
  check_writable(options.output, "--output");
  check_distinct({options.output}, {options.surface, options.mesh});
}

ExitCode run(const EmbedOptions& options) {
  check_files(options);
  const TriangleMesh surface = io::read_surface(options.surface);
  const Embedding embedding = embed_points(io::read_tet_mesh(options.mesh), surface.points);
  write(options.output, surface, embedding);
  if (!options.quiet)
    print_result(fmt::format("{}: {} of {} in tetrahedra of {}\n", options.output,
                             plural(surface.points.size(), "vertex", "vertices"), options.surface,
                             options.mesh));
  return ExitCode::kDone;
}

}  // namespace

Command add_embed(CLI::App& app) {
  const auto options = std::make_shared<EmbedOptions>();
  CLI::App* const parser =
      app.add_subcommand("embed", "Tell where a surface's vertices lie in a mesh, so that it can ride on it");
  parser->add_option("SURFACE", options->surface, "surface file: .stl .obj .off .ply")->required();
  parser->add_option("MESH", options->mesh, "mesh file that covers it: .vtu .msh .mesh .node .ele")
      ->required();
  parser->add_option("-o,--output", options->output, ".npz or .vtu")->required();
  parser->add_flag("--quiet", options->quiet, "print errors only");
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
