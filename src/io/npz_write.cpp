/// \file
/// numpy's .npz: a zip archive with one stored (not compressed) .npy entry an array. Zip: "APPNOTE.TXT - .ZIP
/// File Format Specification" 6.3, sections 4.3.7, 4.3.12 and 4.3.16, all integers little-endian. Npy:
/// numpy's "NPY format" 1.0, a header that is a Python dictionary, padded to 64 bytes.
#include <libdeflate.h>

#include <bit>
#include <limits>
#include <vector>

#include "io/fail.hpp"
#include "io/output.hpp"
#include "unsliver/io_arrays.hpp"

namespace unsliver::io {
namespace {

constexpr std::uint16_t kZipVersion = 20;
/// 1 January 1980, the earliest date that zip has: the same arrays make the same bytes.
constexpr std::uint16_t kDate = (1 << 5) | 1;

struct Entry {
  std::string name;
  std::uint32_t crc, size, offset;
};

std::string_view bytes_of(const NamedArray& array) {
  return std::visit(
      [](const auto& values) {
        return std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes());
      },
      array.values);
}

std::string npy_header(const NamedArray& array) {
  const char order = std::endian::native == std::endian::little ? '<' : '>';
  const char kind = std::holds_alternative<std::span<const double>>(array.values) ? 'f' : 'i';
  const std::size_t rows = bytes_of(array).size() / 8 / array.columns;
  const std::string shape =
      array.columns == 1 ? fmt::format("({},)", rows) : fmt::format("({}, {})", rows, array.columns);
  std::string text =
      fmt::format("{{'descr': '{}{}8', 'fortran_order': False, 'shape': {}, }}", order, kind, shape);
  constexpr std::size_t kPreamble = 10, kAlignment = 64;
  while ((kPreamble + text.size() + 1) % kAlignment != 0) text += ' ';
  text += '\n';
  std::string header = "\x93NUMPY";
  header += '\x01';
  header += '\0';
  header += static_cast<char>(text.size() & 0xff);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

class NpzWriter {
 public:
  explicit NpzWriter(const std::filesystem::path& path) : out_(path) {}

  void add(const NamedArray& array) {
    const std::string header = npy_header(array);
    const std::string_view data = bytes_of(array);
    const std::uint32_t crc =
        libdeflate_crc32(libdeflate_crc32(0, header.data(), header.size()), data.data(), data.size());
    const Entry entry{array.name + ".npy", crc, static_cast<std::uint32_t>(header.size() + data.size()),
                      static_cast<std::uint32_t>(written_)};
    put32(0x04034b50);
    put_common(entry);
    put(entry.name);
    put(header);
    put(data);
    entries_.push_back(entry);
  }

  void finish() {
    const auto start = static_cast<std::uint32_t>(written_);
    for (const Entry& entry : entries_) put_directory_entry(entry);
    const auto size = static_cast<std::uint32_t>(written_ - start);
    const auto count = static_cast<std::uint16_t>(entries_.size());
    put32(0x06054b50);
    put_all16({0, 0, count, count});
    put32(size);
    put32(start);
    put16(0);
    out_.commit();
  }

 private:
  void put(std::string_view bytes) {
    out_.put(bytes);
    written_ += bytes.size();
  }
  void put16(std::uint16_t n) {
    const char bytes[] = {static_cast<char>(n & 0xff), static_cast<char>(n >> 8)};
    put({bytes, 2});
  }
  void put_all16(std::initializer_list<std::uint16_t> numbers) {
    for (const std::uint16_t n : numbers) put16(n);
  }
  void put32(std::uint32_t n) {
    put16(static_cast<std::uint16_t>(n & 0xffff));
    put16(static_cast<std::uint16_t>(n >> 16));
  }

  /// What an entry's own header and its line in the directory share: version, flags, method, time, date, ...
  void put_common(const Entry& entry) {
    put_all16({kZipVersion, 0, 0, 0, kDate});
    put32(entry.crc);
    put32(entry.size);
    put32(entry.size);
    put_all16({static_cast<std::uint16_t>(entry.name.size()), 0});
  }

  void put_directory_entry(const Entry& entry) {
    put32(0x02014b50);
    put16(kZipVersion);
    put_common(entry);
    put_all16({0, 0, 0});
    put32(0);
    put32(entry.offset);
    put(entry.name);
  }

  Output out_;
  std::uint64_t written_ = 0;
  std::vector<Entry> entries_;
};

/// With room for headers.
void require_zip_range(const std::filesystem::path& path, std::span<const NamedArray> arrays) {
  std::uint64_t bytes = 0;
  for (const NamedArray& array : arrays) bytes += bytes_of(array).size() + 1024 + 2 * array.name.size();
  if (bytes > std::numeric_limits<std::uint32_t>::max())
    fail(ErrorCode::kUnsupported, "{}: {} bytes are more than a .npz file without zip64 can hold",
         path.string(), bytes);
}

}  // namespace

void write_npz(const std::filesystem::path& path, std::span<const NamedArray> arrays) {
  require_zip_range(path, arrays);
  NpzWriter writer(path);
  for (const NamedArray& array : arrays) writer.add(array);
  writer.finish();
}

}  // namespace unsliver::io
