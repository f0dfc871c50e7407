#include "text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "unsliver/error.hpp"

namespace unsliver::cli {
namespace {

constexpr std::string_view kBlanks = " \t\r\n,;";

/// The next word of `text` from `position` on, which moves behind it; empty at the end.
std::string next_word(const std::string& text, std::size_t& position) {
  const std::size_t begin = text.find_first_not_of(kBlanks, position);
  if (begin == std::string::npos) return {};
  position = std::min(text.find_first_of(kBlanks, begin), text.size());
  return text.substr(begin, position - begin);
}

/// A positive number with a one-letter suffix out of `suffixes`, each worth `step` times the one before.
std::uint64_t parse_scaled(std::string text, std::string_view suffixes, double step, const Error& complaint) {
  double factor = 1;
  if (!text.empty()) {
    const std::size_t index = suffixes.find(text.back() == 'k' ? 'K' : text.back());
    if (index != std::string_view::npos) {
      factor = std::pow(step, static_cast<double>(index + 1));
      text.pop_back();
    }
  }
  const auto number = parse_number(text);
  if (!number || !(*number * factor >= 1) || !(*number * factor < 1e18)) throw complaint;
  return static_cast<std::uint64_t>(*number * factor);
}

}  // namespace

std::string with_separators(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::string human_count(double n) {
  if (n < 1e6) return with_separators(static_cast<std::uint64_t>(std::llround(n)));
  if (n < 1e9) return fmt::format("{:.3g} million", n / 1e6);
  if (n < 1e12) return fmt::format("{:.3g} billion", n / 1e9);
  return fmt::format("{:.2e}", n);
}

std::string human_bytes(double bytes) {
  const char* const units[] = {"bytes", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  if (!(bytes < 1e18)) return fmt::format("{:.2e} bytes", bytes);
  for (; bytes >= 999.5 && unit + 1 < std::size(units); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

std::string human_seconds(double seconds) {
  if (seconds < 9.995) return fmt::format("{:.2f} s", seconds);
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string plural(std::uint64_t n, const std::string& noun, const std::string& nouns) {
  return with_separators(n) + " " + (n == 1 ? noun : nouns.empty() ? noun + "s" : nouns);
}

std::string point_text(const Vec3& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

std::string box_text(const Box3& box) { return point_text(box.lo) + " to " + point_text(box.hi); }

std::optional<double> parse_number(const std::string& text) {
  std::size_t position = 0;
  const std::string word = next_word(text, position);
  if (word.empty() || !next_word(text, position).empty()) return std::nullopt;
  const char* const begin = word.data() + (word.front() == '+' ? 1 : 0);
  const char* const end = word.data() + word.size();
  double value = 0;
  const auto [rest, failure] = std::from_chars(begin, end, value);
  if (failure != std::errc{} || rest != end) return std::nullopt;
  return std::isnan(value) ? std::abs(value) : value;  // "-nan" would puzzle people
}

std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& option) {
  std::vector<double> numbers;
  std::size_t position = 0;
  for (std::string word = next_word(text, position); !word.empty(); word = next_word(text, position)) {
    const auto number = parse_number(word);
    if (!number)
      throw Error(ErrorCode::kBadOption,
                  fmt::format("{}: \"{}\" is not a number (in \"{}\")", option, word, text));
    numbers.push_back(*number);
  }
  if (numbers.size() != count)
    throw Error(ErrorCode::kBadOption, fmt::format("{} takes {} numbers in quotes, but \"{}\" holds {}",
                                                   option, count, text, numbers.size()));
  return numbers;
}

std::uint64_t parse_count(const std::string& text, const std::string& option) {
  return parse_scaled(
      text, "KMG", 1000,
      Error(ErrorCode::kBadOption,
            fmt::format("{} is \"{}\": give a positive number such as 500000, 500k or 20M", option, text)));
}

std::uint64_t parse_bytes(const std::string& text, const std::string& option) {
  return parse_scaled(
      text, "KMGT", 1024,
      Error(ErrorCode::kBadOption,
            fmt::format("{} is \"{}\": give a positive number of bytes such as 500M or 8G", option, text)));
}

}  // namespace unsliver::cli
