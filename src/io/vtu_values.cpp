#include "io/vtu_values.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <optional>

#include "io/base64.hpp"
#include "io/fail.hpp"
#include "io/scanner.hpp"
#include "io/zlib_blocks.hpp"

namespace unsliver::io {
namespace {

[[noreturn]] void fail_array(const VtuDocument& document, const VtuArray& array, ErrorCode code,
                             std::string_view message) {
  fail(code, "{}: array '{}' of {}: {}", document.name, array.name.substr(0, 40), array.section, message);
}

[[noreturn]] void fail_damaged(const VtuDocument& document, const VtuArray& array, std::string_view message) {
  fail_array(document, array, ErrorCode::kFormat, message);
}

/// Reads the integers that stand before binary data.
class HeaderReader {
 public:
  HeaderReader(const VtuDocument& document, const VtuArray& array, std::string_view bytes)
      : document_(document), array_(array), bytes_(bytes) {}

  std::uint64_t next() { return document_.header_size == 8 ? read<std::uint64_t>() : read<std::uint32_t>(); }
  std::string_view take(std::uint64_t size) {
    if (bytes_.size() < size) fail_damaged(document_, array_, "its data is truncated");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  std::size_t bytes_left() const { return bytes_.size(); }

 private:
  template <class Integer>
  Integer read() {
    Integer value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return document_.swapped ? byte_swapped(value) : value;
  }

  const VtuDocument& document_;
  const VtuArray& array_;
  std::string_view bytes_;
};

// Size of all blocks together; every one but the last has the full size.
std::optional<std::uint64_t> decompressed_size(std::uint64_t count, std::uint64_t block_size,
                                               std::uint64_t last_size, std::uint64_t most) {
  const std::uint64_t last = last_size == 0 ? block_size : last_size;
  if (last > most || last > block_size) return std::nullopt;
  if (count > 1 && block_size > (most - last) / (count - 1)) return std::nullopt;
  return block_size * (count - 1) + last;
}

std::string decompressed(const VtuDocument& document, const VtuArray& array, std::string_view bytes) {
  HeaderReader reader(document, array, bytes);
  const std::uint64_t count = reader.next();
  const std::uint64_t block_size = reader.next();
  const std::uint64_t last_size = reader.next();
  if (count == 0) return {};
  const auto size = decompressed_size(count, block_size, last_size, kMaxZlibRatio * reader.bytes_left());
  if (!size || count > reader.bytes_left() / document.header_size)
    fail_damaged(document, array, "it declares more data than the file can hold");

  std::vector<std::uint64_t> stream_sizes(count);
  for (std::uint64_t& size : stream_sizes) size = reader.next();
  std::string data(*size, '\0');
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t begin = i * block_size;
    const std::uint64_t wanted = std::min<std::uint64_t>(block_size, data.size() - begin);
    if (!decompress_block(reader.take(stream_sizes[i]), data.data() + begin, wanted))
      fail_damaged(document, array, "a compressed block is damaged");
  }
  return data;
}

// The array's numbers as they lie in memory, still in the file's byte order.
std::string binary_data(const VtuDocument& document, const VtuArray& array) {
  const bool appended = array.format == VtuFormat::kAppended;
  std::string_view bytes = appended ? document.appended_at(array.offset) : array.text;
  std::string decoded;
  if (!appended || document.appended_is_base64) {
    auto maybe = decode_base64(bytes);
    if (!maybe) fail_damaged(document, array, "its data is not base64");
    decoded = std::move(*maybe);
    bytes = decoded;
  }
  if (bytes.empty()) {
    if (appended) fail_damaged(document, array, "its offset lies outside the appended data");
    return {};
  }
  if (document.compressed) return decompressed(document, array, bytes);
  HeaderReader reader(document, array, bytes);
  return std::string(reader.take(reader.next()));
}

template <class T, class Stored>
T converted(const VtuDocument& document, const VtuArray& array, Stored value) {
  if constexpr (std::integral<T> && std::floating_point<Stored>) {
    if (!(std::abs(value) < 9e18)) fail_array(document, array, ErrorCode::kBadInput, "a value is no index");
  } else if constexpr (std::integral<T> && std::same_as<Stored, std::uint64_t>) {
    if (value > static_cast<std::uint64_t>(std::numeric_limits<T>::max()))
      fail_array(document, array, ErrorCode::kBadInput, "a value is too large");
  }
  return static_cast<T>(value);
}

template <class T, class Stored>
std::vector<T> unpacked(const VtuDocument& document, const VtuArray& array) {
  const std::string data = binary_data(document, array);
  if (data.size() % sizeof(Stored) != 0) fail_damaged(document, array, "its data ends within a value");
  std::vector<T> values(data.size() / sizeof(Stored));
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored stored;
    std::memcpy(&stored, data.data() + i * sizeof(Stored), sizeof(Stored));
    if (document.swapped) stored = byte_swapped(stored);
    values[i] = converted<T>(document, array, stored);
  }
  return values;
}

template <class T>
std::vector<T> parsed_text(const VtuDocument& document, const VtuArray& array) {
  Scanner scanner(array.text,
                  fmt::format("{}: array '{}', its line", document.name, array.name.substr(0, 40)));
  std::vector<T> values;
  while (!scanner.at_end()) {
    if constexpr (std::integral<T>)
      values.push_back(scanner.integer("a value"));
    else
      values.push_back(scanner.number("a value"));
  }
  return values;
}

}  // namespace

template <class T>
std::vector<T> vtu_values(const VtuDocument& document, const VtuArray& array) {
  if (array.format == VtuFormat::kAscii) return parsed_text<T>(document, array);
  if (array.type == "Float64") return unpacked<T, double>(document, array);
  if (array.type == "Float32") return unpacked<T, float>(document, array);
  if (array.type == "Int8") return unpacked<T, std::int8_t>(document, array);
  if (array.type == "UInt8") return unpacked<T, std::uint8_t>(document, array);
  if (array.type == "Int16") return unpacked<T, std::int16_t>(document, array);
  if (array.type == "UInt16") return unpacked<T, std::uint16_t>(document, array);
  if (array.type == "Int32") return unpacked<T, std::int32_t>(document, array);
  if (array.type == "UInt32") return unpacked<T, std::uint32_t>(document, array);
  if (array.type == "Int64") return unpacked<T, std::int64_t>(document, array);
  if (array.type == "UInt64") return unpacked<T, std::uint64_t>(document, array);
  fail_damaged(document, array, fmt::format("its type '{}' is unknown", array.type.substr(0, 40)));
}

template std::vector<double> vtu_values(const VtuDocument&, const VtuArray&);
template std::vector<std::int64_t> vtu_values(const VtuDocument&, const VtuArray&);

}  // namespace unsliver::io
