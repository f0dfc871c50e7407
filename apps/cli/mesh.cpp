/// \file
/// `unsliver mesh`: read, estimate, mesh, verify, write, report.
#include <memory>

#include "commands.hpp"
#include "mesh_command.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kFooter = R"text(Strategies, all with the same limits on angles and size:
  octree   by far the fastest; few vertices where the size varies slowly. Points must lie in the
           domain's box; then most of the mesh is still made that fast
  closure  fewest vertices where the size varies. Without points
  thrifty  fewest vertices beside points, or where the limits are relaxed
  literal  the paper's figures to the letter: up to 4 times the vertices
  auto     with points thrifty; else octree where the size varies slowly or not at all,
           thrifty where the limits are relaxed, and closure

Examples:
  unsliver mesh spot.obj -o spot.vtu --size 0.02
  unsliver mesh part.stl -o part.msh --edge-length 1.5 --size-gradation 0.3 --size-max 10
  unsliver mesh --box "0 0 0 1 1 2" -o box.mesh --size "0.02 + 0.1 * z"
  unsliver mesh --implicit "x^2 + y^2 + z^2 - 1 - 0.2 * sin(9 * x)" \
                --bounds "-2 -2 -2 2 2 2" -o blob.vtu --max-tets 20M --keep-partial
  unsliver mesh --points atoms.pqr -o atoms.vtu --min-angle 20
  unsliver mesh --box "0 0 0 1 1 1" --periodic --points atoms.xyz -o cell.msh
The mesh is a superset of the domain: all tetrahedra that meet it, none of them bad.)text";

}  // namespace

Command add_mesh(CLI::App& app) {
  const auto options = std::make_shared<MeshCommandOptions>();
  CLI::App* const parser =
      app.add_subcommand("mesh", "Mesh a solid: every dihedral angle between 30 and 135 degrees");
  add_mesh_options(*parser, *options);
  parser->footer(kFooter);
  return {parser, [options] { return run_mesh_command(*options); }};
}

}  // namespace unsliver::cli
