/// \file
/// `unsliver refine`: an existing tetrahedral mesh, its vertices kept, its slivers refined away.
#include <memory>

#include "commands.hpp"
#include "mesh_command.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver refine part.1.ele -o part.vtu
  unsliver refine part.msh -o better.msh --min-angle 15 --max-angle 150 --max-radius-edge 1.5
Every vertex of MESH is a vertex of the result, bit for bit; its tetrahedra are replaced. The result
is a superset mesh of their union: all tetrahedra that meet it, none of them bad.)text";

}  // namespace

Command add_refine(CLI::App& app) {
  const auto options = std::make_shared<MeshCommandOptions>();
  CLI::App* const parser =
      app.add_subcommand("refine", "Refine the slivers of a tetrahedral mesh away, its vertices kept");
  add_refine_options(*parser, *options);
  parser->footer(kExamples);
  return {parser, [options] { return run_mesh_command(*options); }};
}

}  // namespace unsliver::cli
