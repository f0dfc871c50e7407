#include "io/zlib_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/deflate_words.hpp"
#include "io/fail.hpp"

namespace unsliver::io {
namespace {

constexpr std::size_t kBlockSize = std::size_t{32} * 32768;

void append_integer(std::string& bytes, std::uint64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_compressed(std::string_view block, std::string& out) {
  const std::size_t start = out.size();
  uLongf size = compressBound(static_cast<uLong>(block.size()));
  out.resize(start + size);
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data() + start), &size,
                reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()), Z_BEST_SPEED);
  if (status != Z_OK) fail(ErrorCode::kLimit, "zlib could not compress (status {}): out of memory", status);
  out.resize(start + size);
}

// append(begin, size, out) appends one block's stream.
template <class Append>
std::string blocks_of(std::size_t size, const Append& append) {
  const std::size_t count = (size + kBlockSize - 1) / kBlockSize;
  std::string out;
  append_integer(out, count);
  append_integer(out, kBlockSize);
  append_integer(out, size % kBlockSize);
  const std::size_t sizes = out.size();
  out.resize(sizes + count * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t start = out.size(), begin = i * kBlockSize;
    append(begin, std::min(kBlockSize, size - begin), out);
    const std::uint64_t stream_size = out.size() - start;
    std::memcpy(out.data() + sizes + i * sizeof stream_size, &stream_size, sizeof stream_size);
  }
  return out;
}

}  // namespace

std::string compress_blocks(std::string_view bytes) {
  return blocks_of(bytes.size(), [&](std::size_t begin, std::size_t size, std::string& out) {
    append_compressed(bytes.substr(begin, size), out);
  });
}

std::string compress_words(std::span<const std::uint32_t> words) {
  if constexpr (std::endian::native == std::endian::big)
    return compress_blocks({reinterpret_cast<const char*>(words.data()), words.size_bytes()});
  return blocks_of(words.size_bytes(), [&](std::size_t begin, std::size_t size, std::string& out) {
    append_deflated_words(words.subspan(begin / sizeof words[0], size / sizeof words[0]), out);
  });
}

bool decompress_block(std::string_view stream, char* out, std::size_t size) {
  uLongf filled = static_cast<uLongf>(size);
  const int status =
      uncompress(reinterpret_cast<Bytef*>(out), &filled, reinterpret_cast<const Bytef*>(stream.data()),
                 static_cast<uLong>(stream.size()));
  return status == Z_OK && filled == size;
}

}  // namespace unsliver::io
