#include "io/scanner.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

// std::from_chars takes no plus sign.
std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

bool has_negative_exponent(std::string_view word) {
  return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
}

// The number that the word is: 0 or infinity when it is beyond the doubles.
std::optional<double> parsed_number(std::string_view word) {
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    return has_negative_exponent(digits) ? 0.0 : std::numeric_limits<double>::infinity();
  return value;
}

}  // namespace

bool is_number(std::string_view word) { return parsed_number(word).has_value(); }

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  for (char& c : text)
    if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

Scanner::Scanner(std::string_view bytes, std::string name, Dialect dialect)
    : bytes_(bytes), name_(std::move(name)), dialect_(dialect) {
  if (bytes_.starts_with(kUtf8Mark)) position_ = kUtf8Mark.size();
}

// Size of a mark and line end that join this line with the next; 0 when there is none here.
std::size_t Scanner::continuation_size() const {
  if (dialect_.continuation == '\0' || bytes_[position_] != dialect_.continuation) return 0;
  const std::string_view after = bytes_.substr(position_ + 1, 2);
  return after.starts_with('\n') ? 2 : after == "\r\n" ? 3 : 0;
}

void Scanner::skip_blanks() {
  while (position_ < bytes_.size()) {
    if (const std::size_t joint = continuation_size()) {
      position_ += joint;
      continue;
    }
    const char c = bytes_[position_];
    if (dialect_.comment != '\0' && c == dialect_.comment) {
      position_ = std::min(bytes_.find('\n', position_), bytes_.size());
      return;
    }
    if (!is_blank(c)) return;
    ++position_;
  }
}

bool Scanner::at_line_end() {
  skip_blanks();
  return position_ == bytes_.size() || bytes_[position_] == '\n';
}

bool Scanner::at_end() {
  while (at_line_end()) {
    if (position_ == bytes_.size()) return true;
    ++position_;
  }
  return false;
}

void Scanner::next_line(std::string_view what) {
  if (at_end()) fail_at_end(what);
}

void Scanner::skip_line() { position_ = std::min(bytes_.find('\n', position_), bytes_.size() - 1) + 1; }

std::string_view Scanner::line() {
  token_ = position_;
  skip_line();
  const std::string_view found = bytes_.substr(token_, position_ - token_);
  return found.substr(0, found.find_last_not_of("\r\n") + 1);
}

std::string_view Scanner::word(std::string_view what) {
  const bool ended = dialect_.layout == Layout::kLines ? at_line_end() : at_end();
  if (ended) fail_at_end(what);
  token_ = position_;
  while (position_ < bytes_.size() && !is_blank(bytes_[position_]) && bytes_[position_] != '\n') ++position_;
  return bytes_.substr(token_, position_ - token_);
}

std::string_view Scanner::peek() {
  if (at_end()) return {};
  const std::size_t start = position_;
  const std::string_view next = word("a word");
  position_ = start;
  return next;
}

void Scanner::keyword(std::string_view expected) {
  const std::string_view found = word(in_quotes(expected));
  if (!equal_ignoring_case(found, expected))
    fail_here(ErrorCode::kFormat, fmt::format("expected '{}', found {}", expected, in_quotes(found)));
}

double Scanner::number(std::string_view what) { return to_number(word(what), what); }

double Scanner::to_number(std::string_view word, std::string_view what) const {
  const std::optional<double> value = parsed_number(word);
  if (!value)
    fail_here(ErrorCode::kFormat, fmt::format("expected {} (a number), found {}", what, in_quotes(word)));
  return require_finite(*value, what);
}

std::int64_t Scanner::integer(std::string_view what) { return to_integer(word(what), what); }

std::int64_t Scanner::to_integer(std::string_view word, std::string_view what) const {
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range)
    fail_here(ErrorCode::kBadInput, fmt::format("{} is {}, which is too large", what, in_quotes(word)));
  if (error != std::errc{} || end != digits.data() + digits.size())
    fail_here(ErrorCode::kFormat, fmt::format("expected {} (an integer), found {}", what, in_quotes(word)));
  return value;
}

std::int32_t Scanner::label(std::string_view what) {
  const std::int64_t value = integer(what);
  if (value != static_cast<std::int32_t>(value))
    fail_here(ErrorCode::kBadInput, fmt::format("{} is {}, which does not fit 32 bits", what, value));
  return static_cast<std::int32_t>(value);
}

std::size_t Scanner::count(std::string_view what, std::size_t bytes_each) {
  return require_room(integer(fmt::format("the number of {}", what)), bytes_each, what);
}

std::string_view Scanner::take(std::size_t size, std::string_view what) {
  token_ = position_;
  if (bytes_left() < size)
    fail_here(ErrorCode::kFormat,
              fmt::format("the file ends within {}; it is truncated ({} of {} bytes left)", what,
                          bytes_left(), size));
  position_ += size;
  return bytes_.substr(token_, size);
}

std::size_t Scanner::require_room(std::int64_t rows, std::size_t bytes_each, std::string_view what) const {
  if (rows < 0) fail_here(ErrorCode::kFormat, fmt::format("the number of {} is {}", what, rows));
  // The last row of a text may lack its line end.
  const std::size_t room = bytes_left() + (binary_ ? 0 : 1);
  if (static_cast<std::uint64_t>(rows) > room / bytes_each)
    fail_here(ErrorCode::kFormat,
              fmt::format("{} {} are declared, but only {} bytes follow; the file is truncated or damaged",
                          rows, what, bytes_left()));
  return static_cast<std::size_t>(rows);
}

double Scanner::require_finite(double value, std::string_view what) const {
  if (!std::isfinite(value))
    fail_here(ErrorCode::kBadInput, fmt::format("{} is {}; it must be a finite number", what, value));
  return value;
}

VertexId Scanner::require_vertex(std::int64_t index, std::int64_t first, std::size_t vertex_count) const {
  const auto count = static_cast<std::int64_t>(vertex_count);
  if (count == 0)
    fail_here(ErrorCode::kBadInput, fmt::format("vertex index {} is used, but there are no vertices", index));
  if (index < first || index - first >= count)
    fail_here(ErrorCode::kBadInput, fmt::format("vertex index {} is out of range; valid are {} to {}", index,
                                                first, first + count - 1));
  return static_cast<VertexId>(index - first);
}

void Scanner::fail_here(ErrorCode code, const std::string& message) const {
  const auto lines = [&] { return 1 + std::count(bytes_.begin(), bytes_.begin() + token_, '\n'); };
  const std::string place =
      binary_ ? fmt::format("{}: byte {}", name_, token_) : fmt::format("{}:{}", name_, lines());
  const std::string element = element_.empty() ? "" : fmt::format("{} {}: ", element_, element_number_);
  Error error(code, place + ": " + element + message);
  if (!element_.empty()) error.ids.push_back(static_cast<std::int64_t>(element_number_));
  throw error;
}

void Scanner::fail_at_end(std::string_view what) const {
  Scanner end = *this;
  end.token_ = position_;
  const char* part = position_ == bytes_.size() ? "file" : "line";
  end.fail_here(ErrorCode::kFormat, fmt::format("the {} ends where {} was expected", part, what));
}

}  // namespace unsliver::io
