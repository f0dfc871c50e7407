/// \file
/// What is wrong with a command line, in words, and what was probably meant.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace unsliver::cli {

/// The one of `known` that is closest to `word`, leading dashes aside: it starts with the word, or about a
/// third of the letters differ at most. The first of several; none if all are far.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

/// "; did you mean NEAREST?", or nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

/// Of an option whose value is one of `choices`.
CLI::Validator one_of(const std::vector<std::string>& choices);

/// From now on, an option that takes text refuses an empty one, and one that takes a number anything else.
void check_values(CLI::App& parser);

/// `name` is no command of `app`: what to type instead.
std::string unknown_command(const CLI::App& app, const std::string& name);

/// One sentence on `error`, which the parsing of `app` ended with.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace unsliver::cli
