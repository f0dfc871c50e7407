/// \file
/// The program `unsliver`: picks the subcommand, turns whatever goes wrong into a message and an exit code.
#include <array>
#include <new>

#include "commands.hpp"
#include "interrupts.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kAbout =
    "unsliver: tetrahedral meshes whose dihedral angles all lie between 30 and 135 degrees.\n";

constexpr const char* kExamples = R"text(Examples:
  unsliver mesh spot.obj -o spot.vtu --size 0.02
  unsliver mesh --ball "0 0 0 1" -o ball.msh --edge-length 0.1
  unsliver mesh --points atoms.pqr -o atoms.vtu
  unsliver refine old.msh -o new.msh
  unsliver check spot.vtu --against spot.obj
  unsliver view spot.vtu -o spot.png
  unsliver prove all
  unsliver help mesh

Exit codes: 0 done and verified; 1 a cap or a limit was met, or a checked mesh is at fault;
2 bad input or usage; 3 a bug in unsliver.)text";

ExitCode run_guarded(const Command& command) {
  try {
    return command.run();
  } catch (const Error& error) {
    say_error(error.what());
    return exit_code_of(error.code());
  } catch (const std::bad_alloc&) {
    say_error("out of memory. Ask for a larger --size, or set --max-memory to end the run in time");
    return ExitCode::kLimit;
  } catch (const std::exception& error) {
    say_error(std::string("internal error: ") + error.what() +
              ". This is a bug in unsliver; please report it");
    return ExitCode::kBug;
  }
}

ExitCode usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto subcommands = app.get_subcommands();
  const std::string topic = subcommands.empty() ? "" : subcommands.front()->get_name() + " ";
  const std::string message = usage_message(app, error);
  say_error(message + (message.ends_with('?') ? " See `unsliver " : ". See `unsliver ") + topic + "--help`");
  return ExitCode::kUsage;
}

ExitCode run(int argc, char** argv) {
  CLI::App app(kAbout, "unsliver");
  app.set_version_flag("-V,--version", "unsliver " UNSLIVER_VERSION);
  app.require_subcommand(1);
  app.footer(kExamples);
  const std::array commands = {add_mesh(app),    add_refine(app), add_check(app),
                               add_convert(app), add_embed(app),  add_info(app),
                               add_view(app),    add_prove(app),  add_help(app)};
  for (const Command& command : commands) check_values(*command.parser);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help and --version
    app.exit(request);
    return ExitCode::kDone;
  } catch (const CLI::ParseError& error) {
    return usage_error(app, error);
  }
  for (const Command& command : commands)
    if (command.parser->parsed()) return run_guarded(command);
  return ExitCode::kUsage;
}

}  // namespace
}  // namespace unsliver::cli

int main(int argc, char** argv) {
  using namespace unsliver::cli;
  interrupts::install();
  const ExitCode code = run(argc, argv);
  return static_cast<int>(results_arrived() ? code : ExitCode::kUsage);
}
