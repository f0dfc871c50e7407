/// \file
/// Fast formatting into an AtomicFile.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "io/atomic_file.hpp"

namespace unsliver::io {

/// Collects text and raw values and hands them to the file in large portions. Numbers are written as the
/// shortest text that reads back as the same value.
class Output {
 public:
  explicit Output(const std::filesystem::path& destination) : file_(destination) {
    buffer_.reserve(2 * kPortion);
  }

  void put(char c) { buffer_.push_back(c); }
  void put(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= kPortion) flush();
  }
  void put(const char* text) { put(std::string_view(text)); }
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) void put(Number value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    put(std::string_view(text, static_cast<std::size_t>(end - text)));
  }
  /// Several items, one after another.
  template <class... Items>
  void print(const Items&... items) {
    (put(items), ...);
  }
  /// The value's bytes as they lie in memory.
  template <class T>
  void put_raw(const T& value) {
    put(std::string_view(reinterpret_cast<const char*>(&value), sizeof value));
  }

  void commit() {
    flush();
    file_.commit();
  }

 private:
  static constexpr std::size_t kPortion = std::size_t{1} << 18;

  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

  AtomicFile file_;
  std::string buffer_;
};

}  // namespace unsliver::io
