// A zlib stream of one block with dynamic codes (RFC 1951, section 3.2.7). Each number is written in one of
// three ways:
//   repeated   the same number came within the last 32 KiB: a match of 4 bytes
//   near       all but its lowest byte agree with the number before: a literal, and a match of 3 bytes at
//              distance 4
//   new        four literals
// Any other match would cost more time than it saves space.
#include "io/deflate_words.hpp"

#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "io/huffman.hpp"

namespace unsliver::io {
namespace {

using Words = std::span<const std::uint32_t>;

constexpr std::uint32_t kWindow = 32768 / 4;  // in words

// The literal/length alphabet: bytes, the end of the block, lengths from 3.
constexpr std::size_t kEnd = 256, kLength3 = 257, kLength4 = 258, kLengthSymbols = 259;
constexpr std::size_t kDistanceSymbols = 30;
constexpr int kLongestCode = 14;  // four of them go into the bits that Bits can take at once

// How a number is written: 1 to kWindow for a repeated one, the distance in words.
using Token = std::uint16_t;
constexpr Token kNew = 0, kNear = kWindow + 1;

struct Distance {
  std::size_t symbol;
  BitCode extra;
};

Distance distance_of_words(std::uint32_t words) {
  const std::uint32_t value = 4 * words - 1;  // 3 or more
  const int extra = std::bit_width(value) - 2;
  return {static_cast<std::size_t>(2 * extra) + (value >> extra), {value & ((1U << extra) - 1), extra}};
}

// How each number is written, and how often each symbol is: in one pass, for its branches are hard to
// predict.
class Plan {
 public:
  explicit Plan(Words words) : tokens_(words.size()) {
    constexpr int kLogPlaces = 13;
    std::vector<std::uint32_t> places(std::size_t{1} << kLogPlaces, 0U - kWindow - 1);  // too far for any
    for (std::uint32_t i = 0; i < words.size(); ++i) {
      std::uint32_t& place = places[words[i] * 0x9E3779B1U >> (32 - kLogPlaces)];
      const std::uint32_t distance = i - place;
      if (distance <= kWindow && words[place] == words[i])
        add_repeated(i, distance);
      else if (i > 0 && (words[i] ^ words[i - 1]) < 256)
        add_near(i, words[i]);
      else
        add_new(i, words[i]);
      place = i;
    }
  }

  const std::vector<Token>& tokens() const { return tokens_; }

  // Of the length/literal symbols. As of distances, at least two, so that the code is complete.
  std::array<std::uint32_t, kLengthSymbols> length_counts() const {
    std::array<std::uint32_t, kLengthSymbols> counts{};
    for (const auto& bytes : byte_counts_)
      for (std::size_t i = 0; i < 256; ++i) counts[i] += bytes[i];
    counts[kEnd] = 1;
    counts[kLength3] = 1 + token_counts_[kNear];
    for (std::uint32_t words = 1; words <= kWindow; ++words) counts[kLength4] += token_counts_[words];
    return counts;
  }

  std::array<std::uint32_t, kDistanceSymbols> distance_counts() const {
    std::array<std::uint32_t, kDistanceSymbols> counts{1, 1};
    counts[distance_of_words(1).symbol] += token_counts_[kNear];
    for (std::uint32_t words = 1; words <= kWindow; ++words)
      counts[distance_of_words(words).symbol] += token_counts_[words];
    return counts;
  }

 private:
  void add_repeated(std::uint32_t i, std::uint32_t distance) {
    tokens_[i] = static_cast<Token>(distance);
    ++token_counts_[distance];
  }
  void add_near(std::uint32_t i, std::uint32_t word) {
    tokens_[i] = kNear;
    ++token_counts_[kNear];
    ++byte_counts_[0][word & 255];
  }
  void add_new(std::uint32_t i, std::uint32_t word) {
    tokens_[i] = kNew;
    for (int byte = 0; byte < 4; ++byte) ++byte_counts_[byte][word >> 8 * byte & 255];
  }

  std::vector<Token> tokens_;
  std::array<std::uint32_t, kNear + 1> token_counts_{};
  std::array<std::array<std::uint32_t, 256>, 4> byte_counts_{};  // apart, for equal ones follow each other
};

class Bits {
 public:
  explicit Bits(char* out) : out_(out) {}

  // Requires no more than 56 bits since the last flush.
  void add(const BitCode& code) {
    bits_ |= code.bits << length_;
    length_ += code.length;
  }
  // Writes whole bytes. Touches 8.
  void flush() {
    std::memcpy(out_, &bits_, sizeof bits_);
    out_ += length_ / 8;
    bits_ >>= length_ & ~7;
    length_ &= 7;
  }
  // The end of what was written, after which nothing may be added.
  char* finish() {
    length_ += 7;
    flush();
    return out_;
  }

 private:
  char* out_;
  std::uint64_t bits_ = 0;
  int length_ = 0;
};

class Encoder {
 public:
  explicit Encoder(const Plan& plan)
      : lengths_(huffman_code(plan.length_counts(), kLongestCode)),
        distances_(huffman_code(plan.distance_counts(), kLongestCode)),
        repeated_(kWindow + 1) {
    for (std::uint32_t distance = 1; distance <= kWindow; ++distance)
      repeated_[distance] = match(kLength4, distance);
    near_ = match(kLength3, 1);
  }

  // The lengths of all codes, each in 4 bits: in the code of lengths, all symbols but those of runs are
  // alike.
  void write_codes(Bits& bits) const {
    constexpr int kSymbols = 19, kRuns = 3;
    bits.add({1, 1});  // the last block
    bits.add({2, 2});  // with dynamic codes
    bits.add({kLengthSymbols - 257, 5});
    bits.add({kDistanceSymbols - 1, 5});
    bits.add({kSymbols - 4, 4});
    for (int i = 0; i < kSymbols; ++i) {
      bits.flush();
      bits.add({i < kRuns ? 0U : 4U, 3});
    }
    const std::vector<BitCode> code_of_lengths = huffman_code(std::vector<std::uint32_t>(16, 1), 4);
    for (const auto* codes : {&lengths_, &distances_})
      for (const BitCode& code : *codes) {
        bits.flush();
        bits.add(code_of_lengths[static_cast<std::size_t>(code.length)]);
      }
    bits.flush();
  }

  void write_word(std::uint32_t word, Token token, Bits& bits) const {
    if (token == kNew) {
      for (int byte = 0; byte < 4; ++byte) bits.add(lengths_[word >> 8 * byte & 255]);
    } else if (token == kNear) {
      bits.add(lengths_[word & 255]);
      bits.add(near_);
    } else {
      bits.add(repeated_[token]);
    }
    bits.flush();
  }

  void write_end(Bits& bits) const { bits.add(lengths_[kEnd]); }

 private:
  BitCode match(std::size_t length_symbol, std::uint32_t distance_words) const {
    const Distance distance = distance_of_words(distance_words);
    return lengths_[length_symbol] + distances_[distance.symbol] + distance.extra;
  }

  std::vector<BitCode> lengths_, distances_, repeated_;
  BitCode near_;
};

// The most that a block can need, with what Bits touches beyond it.
std::size_t bound(std::size_t words) { return 7 * words + 512; }

}  // namespace

void append_deflated_words(Words words, std::string& out) {
  const Plan plan(words);
  const Encoder encoder(plan);
  std::vector<char> block(bound(words.size()));
  Bits bits(block.data());
  encoder.write_codes(bits);
  for (std::size_t i = 0; i < words.size(); ++i) encoder.write_word(words[i], plan.tokens()[i], bits);
  encoder.write_end(bits);

  const auto checksum =
      adler32(1, reinterpret_cast<const Bytef*>(words.data()), static_cast<uInt>(words.size_bytes()));
  out.append({'\x78', '\x01'});  // DEFLATE with a window of 32 KiB, made for speed
  out.append(block.data(), bits.finish());
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>(checksum >> shift));
}

}  // namespace unsliver::io
