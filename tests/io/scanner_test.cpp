#include "io/scanner.hpp"

#include <cmath>
#include <random>

#include "io_test_util.hpp"

namespace unsliver::io {
namespace {

TEST(Scanner, ReadsWordsOverLinesAndComments) {
  Scanner scanner("  a # no\n\n# no\n\tb\r\nc", "f", {.comment = '#'});
  EXPECT_EQ(scanner.word("w"), "a");
  EXPECT_EQ(scanner.peek(), "b");
  EXPECT_EQ(scanner.word("w"), "b");
  EXPECT_EQ(scanner.word("w"), "c");
  EXPECT_TRUE(scanner.at_end());
}

TEST(Scanner, StaysOnTheLineWhenAsked) {
  Scanner scanner("1\n2", "f", {.layout = Layout::kLines});
  EXPECT_EQ(scanner.integer("a count"), 1);
  expect_error(ErrorCode::kFormat, {"f:1: the line ends where a size was expected"},
               [&] { scanner.integer("a size"); });
  scanner.next_line("more");
  EXPECT_EQ(scanner.integer("a size"), 2);
}

TEST(Scanner, JoinsContinuedLines) {
  Scanner scanner("1 \\\n2 \\\r\n 3\n4", "f", {.continuation = '\\', .layout = Layout::kLines});
  for (int expected = 1; expected <= 3; ++expected) EXPECT_EQ(scanner.integer("n"), expected);
  EXPECT_TRUE(scanner.at_line_end());
}

TEST(Scanner, SkipsTheUtf8Mark) {
  Scanner scanner("\xef\xbb\xbfOFF", "f");
  EXPECT_EQ(scanner.word("w"), "OFF");
}

TEST(Scanner, ReadsNumbersAsThePrinterWroteThem) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", value);
    SCOPED_TRACE(text);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(Scanner(text, "f").number("n")),
              std::bit_cast<std::uint64_t>(value));
  }
}

TEST(Scanner, TakesPlusSignsAndVanishingNumbers) {
  EXPECT_EQ(Scanner("+1.5", "f").number("n"), 1.5);
  EXPECT_EQ(Scanner("+7", "f").integer("n"), 7);
  EXPECT_EQ(Scanner("1e-999", "f").number("n"), 0.0);
}

TEST(Scanner, RefusesWhatIsNoNumber) {
  for (const char* text : {"abc", "1.2.3", "0x10", "--1", "+-1", "1,5", "+"}) {
    SCOPED_TRACE(text);
    expect_error(ErrorCode::kFormat, {"f:1: ", "expected a size (a number)", text},
                 [&] { Scanner(text, "f").number("a size"); });
  }
  expect_error(ErrorCode::kFormat, {"expected a count (an integer), found '1.5'"},
               [] { Scanner("1.5", "f").integer("a count"); });
  expect_error(ErrorCode::kBadInput, {"too large"},
               [] { Scanner("99999999999999999999", "f").integer("n"); });
  expect_error(ErrorCode::kBadInput, {"does not fit 32 bits"}, [] { Scanner("3000000000", "f").label("n"); });
}

TEST(Scanner, RefusesWhatIsNotFinite) {
  for (const char* text : {"nan", "inf", "-inf", "1e999"}) {
    SCOPED_TRACE(text);
    expect_error(ErrorCode::kBadInput, {"f:2: vertex 5: a size is ", "finite"}, [&] {
      const std::string bytes = std::string("\n") + text;
      Scanner scanner(bytes, "f");
      scanner.at("vertex", 5);
      scanner.number("a size");
    });
  }
}

TEST(Scanner, ErrorsCarryTheElementsNumber) {
  Scanner scanner("x", "f");
  scanner.at("face", 17);
  try {
    scanner.integer("n");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.ids, std::vector<std::int64_t>{17});
  }
}

TEST(Scanner, MessagesQuoteWordsShortAndPrintable) {
  const std::string word(500, '\x01');
  try {
    Scanner(word, "f").integer("n");
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_LT(message.size(), 120u);
    EXPECT_EQ(message.find('\x01'), std::string::npos);
  }
}

TEST(Scanner, ReadsBothByteOrders) {
  const std::string bytes{'\x01', '\x02', '\x03', '\x04'};
  Scanner big(bytes, "f"), little(bytes, "f");
  big.set_binary(std::endian::big);
  little.set_binary(std::endian::little);
  EXPECT_EQ(big.raw<std::uint32_t>("n"), 0x01020304u);
  EXPECT_EQ(little.raw<std::uint32_t>("n"), 0x04030201u);
  expect_error(ErrorCode::kFormat, {"f: byte 4: the file ends within n"}, [&] { big.raw<char>("n"); });
}

TEST(Scanner, ChecksDeclaredCountsAgainstTheBytesLeft) {
  Scanner scanner("4000000000 1 2 3", "f");
  expect_error(ErrorCode::kFormat, {"f:1: 4000000000 vertices are declared, but only 6 bytes follow"},
               [&] { scanner.count("vertices", 6); });
  expect_error(ErrorCode::kFormat, {"the number of rows is -1"}, [] { Scanner("-1", "f").count("rows", 1); });
  EXPECT_EQ(Scanner("2 1 1", "f").count("rows", 2), 2u);
}

TEST(Scanner, ChecksVertices) {
  const Scanner scanner("", "f");
  EXPECT_EQ(scanner.require_vertex(1, 1, 3), 0u);
  EXPECT_EQ(scanner.require_vertex(3, 1, 3), 2u);
  for (const std::int64_t bad : {std::int64_t{0}, std::int64_t{4}, INT64_MIN, INT64_MAX})
    expect_error(ErrorCode::kBadInput, {std::to_string(bad) + " is out of range; valid are 1 to 3"},
                 [&] { scanner.require_vertex(bad, 1, 3); });
}

}  // namespace
}  // namespace unsliver::io
