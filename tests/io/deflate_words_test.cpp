#include "io/deflate_words.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <numeric>
#include <random>

#include "io/huffman.hpp"
#include "io/zlib_blocks.hpp"

namespace unsliver::io {
namespace {

using Words = std::vector<std::uint32_t>;

std::string deflated(const Words& words) {
  std::string stream;
  append_deflated_words(words, stream);
  return stream;
}

// zlib is the judge.
void expect_round_trip(const Words& words) {
  const std::string stream = deflated(words);
  Words back(words.size() + 1);
  ASSERT_TRUE(decompress_block(stream, reinterpret_cast<char*>(back.data()), 4 * words.size()));
  back.resize(words.size());
  EXPECT_EQ(back, words);
}

TEST(DeflateWords, ZlibReadsWhatRandomNumbersGive) {
  std::mt19937_64 bits(1);
  const std::function<std::uint32_t(std::uint32_t)> families[] = {
      [&](std::uint32_t) { return std::uint32_t(bits()); },
      [&](std::uint32_t) { return std::uint32_t(bits() % 3); },
      [&](std::uint32_t) { return std::uint32_t(bits() % 20000); },
      [&](std::uint32_t i) { return i / 3 + std::uint32_t(bits() % 300); },
      [&](std::uint32_t i) { return i / 5 * 256 + std::uint32_t(bits() % 7); },
      [](std::uint32_t i) { return 4 * i + 4; },
      [](std::uint32_t) { return 0U; },
      [](std::uint32_t) { return 0xFFFFFFFFU; },
      [&](std::uint32_t) { return 1U << std::countr_zero(bits() | 1U << 31); },  // codes of all lengths
  };
  for (std::size_t family = 0; family < std::size(families); ++family)
    for (const std::uint32_t size : {0U, 1U, 2U, 3U, 100U, 8193U, 20000U, 262144U}) {
      SCOPED_TRACE(testing::Message() << "family " << family << ", " << size << " numbers");
      Words words(size);
      for (std::uint32_t i = 0; i < size; ++i) words[i] = families[family](i);
      expect_round_trip(words);
    }
}

TEST(DeflateWords, RepetitionsAreFoundThroughoutTheWindow) {
  std::mt19937_64 bits(2);
  for (const std::size_t distance : {1U, 2U, 3U, 4U, 100U, 4095U, 4096U, 8191U, 8192U, 8193U, 9000U}) {
    SCOPED_TRACE(distance);
    Words words(distance + 1);
    for (std::uint32_t& word : words) word = std::uint32_t(bits());
    words.back() = words.front();
    expect_round_trip(words);
  }
}

TEST(DeflateWords, NeighboursDifferInTheLowestByteOnly) {
  for (const std::uint32_t other : {0x12345600U, 0x123456FFU, 0x12345778U, 0x12355678U, 0x13345678U})
    expect_round_trip({0x12345678U, other});
}

TEST(DeflateWords, IndicesShrink) {
  std::mt19937_64 bits(3);
  Words corners(200000), ends(200000);
  for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i / 20 + std::uint32_t(bits() % 200);
  std::iota(ends.begin(), ends.end(), 1U);
  EXPECT_LT(deflated(corners).size(), 2 * corners.size());
  EXPECT_LT(deflated(ends).size(), 3 * ends.size() / 2);
}

TEST(DeflateWords, AppendsAndCostsLittleWhereNothingRepeats) {
  std::mt19937_64 bits(4);
  Words words(100000);
  for (std::uint32_t& word : words) word = std::uint32_t(bits());
  std::string out = "before";
  append_deflated_words(words, out);
  EXPECT_EQ(out, "before" + deflated(words));
  EXPECT_LT(out.size(), 4.05 * double(words.size()));
}

// Counts of a Fibonacci sequence make Huffman's longest codes.
TEST(Huffman, CodesAreCompletePrefixFreeAndNoLongerThanAsked) {
  std::vector<std::uint32_t> counts = {1, 1};
  while (counts.size() < 40) counts.push_back(counts[counts.size() - 1] + counts[counts.size() - 2]);
  for (const int longest : {6, 7, 14}) {
    SCOPED_TRACE(longest);
    const std::vector<BitCode> code = huffman_code(counts, longest);
    std::vector<int> owners(std::size_t{1} << longest, 0);  // of each sequence of bits: one code begins it
    for (const BitCode& c : code) {
      ASSERT_GE(c.length, 1);
      ASSERT_LE(c.length, longest);
      for (std::size_t bits = c.bits; bits < owners.size(); bits += std::size_t{1} << c.length)
        ++owners[bits];
    }
    EXPECT_EQ(owners, std::vector<int>(owners.size(), 1));
    for (std::size_t i = 1; i < code.size(); ++i) EXPECT_LE(code[i].length, code[i - 1].length);
  }
}

TEST(Huffman, IsOptimalWithoutALimit) {
  const std::vector<std::uint32_t> counts = {0, 5, 9, 12, 13, 16, 45, 0};
  const std::vector<BitCode> code = huffman_code(counts, 14);
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    total += std::uint64_t{counts[i]} * unsigned(code[i].length);
  EXPECT_EQ(total, 224U) << "45 * 1 + (12 + 13 + 16) * 3 + (5 + 9) * 4";
  EXPECT_EQ(code.front().length, 0);
  EXPECT_EQ(code.back().length, 0);
}

}  // namespace
}  // namespace unsliver::io
