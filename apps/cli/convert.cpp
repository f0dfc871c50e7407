/// \file
/// `unsliver convert`: a tetrahedral mesh from one format to another.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "files.hpp"
#include "interrupts.hpp"
#include "mesh_options.hpp"
#include "raw_mesh.hpp"
#include "terminal.hpp"
#include "text.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver convert mesh.msh mesh.vtu
  unsliver convert mesh.vtu mesh.msh --format msh41 --ascii
Coordinates, region and boundary labels are kept as far as both formats have a place for them. Only .vtu
keeps the lattice of unsliver's meshes (its frame and each vertex's level): `unsliver check` holds them to
their guarantees from .vtu alone.)text";

struct ConvertOptions {
  std::string from, to;
  io::WriteOptions write;
  bool quiet = false;
};

ExitCode run(const ConvertOptions& options) {
  const bool raw = is_raw_mesh(options.from);
  if (!raw) check_readable(options.from);
  check_write_options(options.to, options.write);
  check_distinct({options.to}, {options.from});
  const TetMesh mesh = raw ? read_raw_mesh(options.from) : io::read_tet_mesh(options.from);
  {
    const interrupts::Hold hold(interrupts::Hold::For::kFile);
    io::write_tet_mesh(options.to, mesh, options.write);
  }
  if (!options.quiet)
    print_result(fmt::format("{}: {}, {}\n", options.to, plural(mesh.points.size(), "vertex", "vertices"),
                             plural(mesh.tets.size(), "tetrahedron", "tetrahedra")));
  return ExitCode::kDone;
}

}  // namespace

Command add_convert(CLI::App& app) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* const parser = app.add_subcommand("convert", "Convert a tetrahedral mesh to another format");
  parser
      ->add_option("FROM", options->from,
                   "mesh file: .vtu .msh .mesh .node .ele, or a folder of mesh --stream")
      ->required();
  parser->add_option("TO", options->to, "mesh file: .vtu .msh .mesh .node")->required();
  add_write_options(*parser, options->write);
  parser->add_flag("--quiet", options->quiet, "print errors only");
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
