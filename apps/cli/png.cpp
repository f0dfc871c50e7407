#include "png.hpp"

#include <libdeflate.h>

#include <array>
#include <cstdint>
#include <memory>
#include <new>

namespace unsliver::cli {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr char kBitDepth = 8, kTrueColour = 2, kNoFilter = 0;
constexpr int kLevel = 6;  // libdeflate's default

void append_big_endian(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
}

void append_chunk(std::string& out, const char* type, const std::string& data) {
  append_big_endian(out, static_cast<std::uint32_t>(data.size()));
  const std::string body = type + data;
  out += body;
  append_big_endian(out, libdeflate_crc32(0, body.data(), body.size()));
}

std::string header(const Image& image) {
  std::string data;
  append_big_endian(data, static_cast<std::uint32_t>(image.width()));
  append_big_endian(data, static_cast<std::uint32_t>(image.height()));
  data += {kBitDepth, kTrueColour, 0, 0, 0};
  return data;
}

std::string scanlines(const Image& image) {
  std::string data;
  data.reserve(static_cast<std::size_t>(image.height()) * (3 * static_cast<std::size_t>(image.width()) + 1));
  for (int y = 0; y < image.height(); ++y) {
    data += kNoFilter;
    for (int x = 0; x < image.width(); ++x) {
      const Colour colour = image.at(x, y);
      data += {static_cast<char>(colour.r), static_cast<char>(colour.g), static_cast<char>(colour.b)};
    }
  }
  return data;
}

std::string deflated(const std::string& data) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), data.size()), '\0');
  out.resize(libdeflate_zlib_compress(compressor.get(), data.data(), data.size(), out.data(), out.size()));
  return out;
}

}  // namespace

std::string encode_png(const Image& image) {
  std::string out(kSignature);
  append_chunk(out, "IHDR", header(image));
  append_chunk(out, "IDAT", deflated(scanlines(image)));
  append_chunk(out, "IEND", "");
  return out;
}

}  // namespace unsliver::cli
