/// \file
/// The subcommands. Each adds itself to the parser and hands back what to run when it is the one called.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "exit_code.hpp"

namespace unsliver::cli {

struct Command {
  CLI::App* parser = nullptr;
  std::function<ExitCode()> run;  ///< may throw Error
};

Command add_mesh(CLI::App& app);
Command add_refine(CLI::App& app);
Command add_check(CLI::App& app);
Command add_convert(CLI::App& app);
Command add_embed(CLI::App& app);
Command add_info(CLI::App& app);
Command add_view(CLI::App& app);
Command add_prove(CLI::App& app);
/// It reads what the others have added, and so `app` must outlive it.
Command add_help(CLI::App& app);

}  // namespace unsliver::cli
