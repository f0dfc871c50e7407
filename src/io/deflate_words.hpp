/// \file
/// Fast compression of 32-bit numbers, such as the corners of tetrahedra.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace unsliver::io {

/// Appends the numbers, as they lie in memory, as one zlib stream (RFC 1950). Matches whole numbers where
/// zlib matches any bytes: several times as fast as zlib's fastest level; connectivity gets a fifth larger.
/// Requires a little-endian machine, and fewer than 2^28 numbers.
void append_deflated_words(std::span<const std::uint32_t> words, std::string& out);

}  // namespace unsliver::io
