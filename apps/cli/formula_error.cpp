#include "formula_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace unsliver::cli {
namespace {

/// The column, from 1 on, that the library's message names.
std::optional<std::size_t> column_in(const std::string& message) {
  constexpr std::string_view kBefore = "\", column ";  // behind the formula in quotes
  const std::size_t place = message.rfind(kBefore);
  if (place == std::string::npos) return std::nullopt;
  std::size_t column = 0;
  const char* const digits = message.data() + place + kBefore.size();
  std::from_chars(digits, message.data() + message.size(), column);
  return column;
}

/// Counts letters, of UTF-8.
std::size_t letters(std::string_view text) {
  const auto starts_letter = [](unsigned char c) { return (c & 0xC0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_letter));
}

std::string marked(const std::string& formula, std::size_t column) {
  constexpr std::size_t kBefore = 50, kShown = 76;
  const std::size_t place = std::min(column - 1, formula.size());
  const std::size_t begin = place - std::min(place, kBefore);
  std::string shown = formula.substr(begin, kShown);
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < ' '; }, ' ');
  const std::size_t before = letters(std::string_view(shown).substr(0, place - begin));
  return fmt::format("\n  {}\n  {:>{}}", shown, '^', before + 1);
}

}  // namespace

Error with_caret(const std::string& option, const std::string& formula, const Error& error) {
  const auto column = column_in(error.what());
  return {error.code(),
          fmt::format("{}: {}{}", option, error.what(), column ? marked(formula, *column) : "")};
}

}  // namespace unsliver::cli
