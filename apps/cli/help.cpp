/// \file
/// `unsliver help`: the same as --help, for those who type it first.
#include <memory>

#include "commands.hpp"
#include "terminal.hpp"
#include "unsliver/error.hpp"
#include "usage.hpp"

namespace unsliver::cli {
namespace {

ExitCode run(const CLI::App& app, const std::string& topic) {
  const std::string program = app.get_name();
  if (topic.empty()) {
    print_result(app.get_formatter()->make_help(&app, program, CLI::AppFormatMode::Normal));
    return ExitCode::kDone;
  }
  for (const CLI::App* command : app.get_subcommands({}))
    if (command->get_name() == topic) {
      print_result(command->help(program));
      return ExitCode::kDone;
    }
  throw Error(ErrorCode::kBadOption, unknown_command(app, topic));
}

}  // namespace

Command add_help(CLI::App& app) {
  const auto topic = std::make_shared<std::string>();
  CLI::App* const parser = app.add_subcommand("help", "Print the help of a command, or this one");
  parser->add_option("COMMAND", *topic, "mesh, refine, ...; none: what commands there are");
  return {parser, [&app, topic] { return run(app, *topic); }};
}

}  // namespace unsliver::cli
