/// Grammar, loosest first; the code is emitted while parsing, in postfix order:
///   choice     = comparison [ "?" choice ":" choice ]
///   comparison = sum [ ( "<" | "<=" | ">" | ">=" ) sum ]
///   sum        = product { ( "+" | "-" ) product }
///   product    = factor { ( "*" | "/" ) factor }
///   factor     = { "+" | "-" } factor | primary [ "^" factor ]
///   primary    = number | name | name "(" choice { "," choice } ")" | "(" choice ")"
#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <string_view>

#include "base/plural.hpp"
#include "geom/expression_builder.hpp"
#include "unsliver/error.hpp"

namespace unsliver::geom {
namespace {

constexpr std::size_t kLongestText = 65536;
constexpr int kDeepestNesting = 200;
constexpr int kAnyCount = 1000000;
constexpr int kMostNormOperands = 8;

struct Function {
  std::string_view name;
  Op op;
  int fewest, most;
};

constexpr Function kFunctions[] = {
    {"abs", Op::kAbs, 1, 1},         {"min", Op::kMin, 2, kAnyCount},
    {"max", Op::kMax, 2, kAnyCount}, {"sqrt", Op::kSqrt, 1, 1},
    {"cbrt", Op::kCbrt, 1, 1},       {"exp", Op::kExp, 1, 1},
    {"log", Op::kLog, 1, 1},         {"log10", Op::kLog10, 1, 1},
    {"sin", Op::kSin, 1, 1},         {"cos", Op::kCos, 1, 1},
    {"tan", Op::kTan, 1, 1},         {"asin", Op::kAsin, 1, 1},
    {"acos", Op::kAcos, 1, 1},       {"atan", Op::kAtan, 1, 1},
    {"atan2", Op::kAtan2, 2, 2},     {"sinh", Op::kSinh, 1, 1},
    {"cosh", Op::kCosh, 1, 1},       {"tanh", Op::kTanh, 1, 1},
    {"floor", Op::kFloor, 1, 1},     {"ceil", Op::kCeil, 1, 1},
    {"sign", Op::kSign, 1, 1},       {"hypot", Op::kNorm, 2, kMostNormOperands},
    {"if", Op::kSelect, 3, 3},       {"clamp", Op::kClamp, 3, 3},
};

const Function* find_function(std::string_view name) {
  for (const Function& f : kFunctions)
    if (f.name == name) return &f;
  return nullptr;
}

// Not the <cctype> functions: those depend on the locale and are undefined for bytes above 127.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Program parse() {
    if (text_.size() > kLongestText) {
      throw Error(ErrorCode::kBadOption, fmt::format("The formula has {} characters; at most {} are allowed.",
                                                     text_.size(), kLongestText));
    }
    choice();
    if (peek() != '\0') fail("an operator or the end of the formula");
    return std::move(builder_).finish();
  }

 private:
  /// Counts the nesting of one recursive rule, so that no input can exhaust the machine's stack.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepestNesting) {
        parser_.fail(fmt::format("at most {} nested levels", kDeepestNesting));
      }
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  void choice() {
    comparison();
    if (!accept('?')) return;
    const Level level(*this);
    choice();
    expect(':');
    choice();
    builder_.apply(Op::kSelect);
  }

  void comparison() {
    sum();
    if (peek() != '<' && peek() != '>') return;
    const bool is_less = text_[at_++] == '<';
    const bool or_equal = at_ < text_.size() && text_[at_] == '=';
    if (or_equal) ++at_;
    sum();
    if (peek() == '<' || peek() == '>') {
      fail("no second comparison (write min(a < b, b < c) for a < b < c)");
    }
    builder_.apply(is_less ? (or_equal ? Op::kLessEqual : Op::kLess)
                           : (or_equal ? Op::kGreaterEqual : Op::kGreater));
  }

  void sum() {
    product();
    while (peek() == '+' || peek() == '-') {
      const Op op = text_[at_++] == '+' ? Op::kAdd : Op::kSubtract;
      product();
      builder_.apply(op);
    }
  }

  void product() {
    factor();
    while (peek() == '*' || peek() == '/') {
      const Op op = text_[at_++] == '*' ? Op::kMultiply : Op::kDivide;
      if (at_ < text_.size() && text_[at_] == '*') fail("one operand (powers are written with ^)");
      factor();
      builder_.apply(op);
    }
  }

  void factor() {
    if (peek() == '-' || peek() == '+') {
      const Level level(*this);
      const bool negative = text_[at_++] == '-';
      factor();
      if (negative) builder_.apply(Op::kNegate);
      return;
    }
    primary();
    if (!accept('^')) return;
    const Level level(*this);
    factor();
    builder_.apply(Op::kPower);
  }

  void primary() {
    const char c = peek();
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return name();
    if (!accept('(')) fail("a number, x, y, z, a function or \"(\"");
    const Level level(*this);
    choice();
    expect(')');
  }

  void number() {
    double value = 0;
    const char* first = text_.data() + at_;
    const auto [end, status] = std::from_chars(first, text_.data() + text_.size(), value);
    if (status == std::errc::result_out_of_range) fail("a number within the range of a double");
    if (status != std::errc()) fail("a number");
    at_ += static_cast<std::size_t>(end - first);
    builder_.push_constant(value);
  }

  void name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string_view word = text_.substr(start, at_ - start);
    if (word == "x") return builder_.push(Op::kX);
    if (word == "y") return builder_.push(Op::kY);
    if (word == "z") return builder_.push(Op::kZ);
    if (word == "pi") return builder_.push_constant(std::numbers::pi);
    if (word == "e") return builder_.push_constant(std::numbers::e);
    if (const Function* f = find_function(word)) return call(*f);
    at_ = start;
    fail(known_names());
  }

  void call(const Function& f) {
    expect('(');
    const Level level(*this);
    int count = 0;
    do {
      choice();
      if (++count > f.most) fail(argument_count(f));
      // min and max of many are chains of the two-operand operation.
      if (count > 1 && f.most == kAnyCount) builder_.apply(f.op);
    } while (accept(','));
    if (count < f.fewest) fail(argument_count(f));
    expect(')');
    if (f.most != kAnyCount) builder_.apply(f.op, f.op == Op::kNorm ? count : 0);
  }

  static std::string argument_count(const Function& f) {
    if (f.most == f.fewest)
      return fmt::format("{} of {}", plural(std::size_t(f.fewest), "argument", "arguments"), f.name);
    if (f.most == kAnyCount) return fmt::format("at least {} arguments of {}", f.fewest, f.name);
    return fmt::format("{} to {} arguments of {}", f.fewest, f.most, f.name);
  }

  static std::string known_names() {
    std::string names = "one of x, y, z, pi, e";
    for (const Function& f : kFunctions) names += fmt::format(", {}", f.name);
    return names;
  }

  /// The next character that is not blank, '\0' at the end.
  char peek() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) fail(fmt::format("\"{}\"", c));
  }

  /// \throws Error kBadOption for the character at hand.
  [[noreturn]] void fail(const std::string& expected) {
    const bool at_end = peek() == '\0' && at_ >= text_.size();
    const std::string found = at_end ? "the end" : fmt::format("\"{}\"", text_.substr(at_, 12));
    throw Error(ErrorCode::kBadOption, fmt::format("Formula \"{}\", column {}: expected {}, found {}.",
                                                   excerpt(), at_ + 1, expected, found));
  }

  std::string excerpt() const {
    constexpr std::size_t kShown = 80;
    return text_.size() <= kShown ? std::string(text_) : fmt::format("{}...", text_.substr(0, kShown));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  ProgramBuilder builder_;
};

}  // namespace

Program compile(const std::string& text) { return Parser(text).parse(); }

}  // namespace unsliver::geom
