/// \file
/// Huffman codes as DEFLATE defines them (RFC 1951, section 3.2.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace unsliver::io {

/// Bits to write, the lowest first.
struct BitCode {
  std::uint64_t bits = 0;
  int length = 0;
};

/// First `a`, then `b`.
inline BitCode operator+(const BitCode& a, const BitCode& b) {
  return {a.bits | b.bits << a.length, a.length + b.length};
}

/// A code for each symbol: short where the count is high, of length 0 where it is 0, never longer than
/// `longest`. Complete, as decoders require. Requires two counts or more above 0, and 2^longest >= symbols.
std::vector<BitCode> huffman_code(std::span<const std::uint32_t> counts, int longest);

}  // namespace unsliver::io
