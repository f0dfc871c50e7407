/// \file
/// VTK's compressed arrays: a header of integers (number of blocks, bytes of a block before compression, of
/// the last block if it is shorter, then the compressed bytes of each block), then the blocks as zlib
/// streams.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace unsliver::io {

/// `bytes` in blocks of 1 MiB, with a header of 64-bit integers in native byte order.
std::string compress_blocks(std::string_view bytes);

/// One zlib stream, which must hold exactly `size` bytes. False when it does not.
bool decompress_block(std::string_view stream, char* out, std::size_t size);

/// The most that zlib streams can shrink: declared sizes beyond this are false.
inline constexpr std::uint64_t kMaxZlibRatio = 1032;

}  // namespace unsliver::io
