#include "io/zlib_blocks.hpp"

#include <zlib.h>

#include <algorithm>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

constexpr std::size_t kBlockSize = std::size_t{32} * 32768;

void append_integer(std::string& bytes, std::uint64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Appends the compressed block and returns its size.
std::size_t append_compressed(std::string_view block, std::string& out) {
  const std::size_t start = out.size();
  uLongf size = compressBound(static_cast<uLong>(block.size()));
  out.resize(start + size);
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data() + start), &size,
                reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()), Z_BEST_SPEED);
  if (status != Z_OK) fail(ErrorCode::kLimit, "zlib could not compress (status {}): out of memory", status);
  out.resize(start + size);
  return size;
}

}  // namespace

std::string compress_blocks(std::string_view bytes) {
  std::string blocks;
  std::string sizes;
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < bytes.size(); begin += kBlockSize, ++count)
    append_integer(sizes, append_compressed(bytes.substr(begin, kBlockSize), blocks));

  std::string header;
  append_integer(header, count);
  append_integer(header, kBlockSize);
  append_integer(header, bytes.size() % kBlockSize);
  return header + sizes + blocks;
}

bool decompress_block(std::string_view stream, char* out, std::size_t size) {
  uLongf filled = static_cast<uLongf>(size);
  const int status =
      uncompress(reinterpret_cast<Bytef*>(out), &filled, reinterpret_cast<const Bytef*>(stream.data()),
                 static_cast<uLong>(stream.size()));
  return status == Z_OK && filled == size;
}

}  // namespace unsliver::io
