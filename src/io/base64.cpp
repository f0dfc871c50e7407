#include "io/base64.hpp"

#include <array>
#include <cstdint>

namespace unsliver::io {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::int8_t kNoDigit = -1, kPadding = -2, kSpace = -3;

constexpr std::array<std::int8_t, 256> make_values() {
  std::array<std::int8_t, 256> values{};
  values.fill(kNoDigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::int8_t>(i);
  values['='] = kPadding;
  for (const char c : {' ', '\t', '\r', '\n'}) values[static_cast<unsigned char>(c)] = kSpace;
  return values;
}
constexpr auto kValues = make_values();
static_assert(kValues['A'] == 0 && kValues['/'] == 63 && kValues['-'] == kNoDigit);

// Four characters, of which the last `padding` are '='.
struct Group {
  std::uint32_t bits = 0;
  int size = 0;
  int padding = 0;

  bool add(std::int8_t value) {
    if (value == kNoDigit || (value != kPadding && padding > 0)) return false;
    padding += value == kPadding;
    bits = bits << 6 | (value == kPadding ? 0u : static_cast<std::uint32_t>(value));
    ++size;
    return padding <= 2;
  }
  void append_to(std::string& bytes) const {
    for (int i = 0; i < 3 - padding; ++i) bytes.push_back(static_cast<char>(bits >> (16 - 8 * i) & 0xff));
  }
};

}  // namespace

std::optional<std::string> decode_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  Group group;
  for (const char c : text) {
    const std::int8_t value = kValues[static_cast<unsigned char>(c)];
    if (value == kSpace) continue;
    if (!group.add(value)) return std::nullopt;
    if (group.size < 4) continue;
    group.append_to(bytes);
    group = {};
  }
  if (group.size != 0) return std::nullopt;
  return bytes;
}

}  // namespace unsliver::io
