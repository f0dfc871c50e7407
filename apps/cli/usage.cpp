#include "usage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string_view>

#include "files.hpp"
#include "text.hpp"

namespace unsliver::cli {
namespace {

std::string without_dashes(const std::string& word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// Letters to insert, to leave out, to replace or to swap with their neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({row[j - 1] + 1, last[j] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

bool is_option(const std::string& argument) { return argument.starts_with("-") && !parse_number(argument); }

std::vector<std::string> option_names(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::Option* option : parser.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::string unknown_option(const CLI::App& parser, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  return "unknown option " + name + suggestion(name, option_names(parser));
}

/// Of arguments that nothing takes: an option among them explains the values behind it.
std::string describe_strangers(const CLI::App& parser, const std::vector<std::string>& strangers) {
  const auto option = std::find_if(strangers.begin(), strangers.end(), is_option);
  if (option != strangers.end()) return unknown_option(parser, *option);
  const std::string told = fmt::format("nothing takes \"{}\"", fmt::join(strangers, " "));
  return parse_number(strangers.front())
             ? told + ": the numbers of one option go in quotes, as in --ball \"0 0 0 1\""
             : told;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Other words for the parser's, where those would puzzle people.
std::string describe_error(const CLI::App& parser, const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string name = text.substr(0, text.find_first_of(": "));
  const CLI::Option* const option = parser.get_option_no_throw(name);
  if (option == nullptr) return text;
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError))
    return fmt::format("{} ({})", text, first_line(option->get_description()));
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ArgumentMismatch)) return text;
  return option->count() > 1 ? fmt::format("{} is given {} times: give it once", name, option->count())
                             : name + " needs a value";
}

std::string refuse_empty(const std::string& value) {
  return value.find_first_not_of(" \t\r\n") == std::string::npos ? "the value is empty" : "";
}

std::string refuse_text(const std::string& value) {
  return parse_number(value) ? "" : fmt::format("\"{}\" is not a number", value);
}

std::string refuse_fractions(const std::string& value) {
  const bool whole = !value.empty() && value.find_first_not_of("0123456789") == std::string::npos;
  return whole ? "" : fmt::format("\"{}\" is not a whole number from 0 on", value);
}

}  // namespace

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known) {
  const std::string typed = without_dashes(word);
  std::size_t closest = (typed.size() + 1) / 3 + 1;
  std::optional<std::string> found;
  for (const std::string& candidate : known) {
    const std::string name = without_dashes(candidate);
    const bool is_start = typed.size() >= 2 && name.starts_with(typed);
    const std::size_t distance = is_start ? 0 : edit_distance(typed, name);
    if (distance >= closest) continue;
    closest = distance;
    found = candidate;
  }
  return found;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const auto meant = nearest(word, known);
  return meant ? "; did you mean " + *meant + "?" : "";
}

CLI::Validator one_of(const std::vector<std::string>& choices) {
  const auto refuse = [choices](const std::string& value) {
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return std::string();
    return fmt::format("\"{}\" is none of {}{}", value, fmt::join(choices, ", "), suggestion(value, choices));
  };
  return CLI::Validator(refuse, fmt::format("{{{}}}", fmt::join(choices, ",")));
}

void check_values(CLI::App& parser) {
  for (CLI::Option* option : parser.get_options()) {
    const std::string type = option->get_type_name();
    const auto put_first = [&](auto refuse) { option->transform(CLI::Validator(refuse, "")); };
    if (type.starts_with("TEXT")) put_first(refuse_empty);
    if (type.starts_with("FLOAT")) put_first(refuse_text);
    if (type.starts_with("UINT")) put_first(refuse_fractions);
  }
}

std::string unknown_command(const CLI::App& app, const std::string& name) {
  std::vector<std::string> known = command_names(app);
  for (const std::string& option : option_names(app)) known.push_back(option);
  const std::string told = fmt::format("there is no command \"{}\"", name);
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored)) return told + suggestion(name, known);
  return fmt::format("{}; did you mean `unsliver {} {}`?", told, is_surface_file(name) ? "mesh" : "info",
                     name);
}

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& parser = chosen.empty() ? app : *chosen.front();
  const std::vector<std::string> strangers = parser.remaining();
  if (strangers.empty() && chosen.empty())
    return fmt::format("no command is given: {}", fmt::join(command_names(app), ", "));
  if (strangers.empty()) return describe_error(parser, error);
  return chosen.empty() ? unknown_command(app, strangers.front()) : describe_strangers(parser, strangers);
}

}  // namespace unsliver::cli
