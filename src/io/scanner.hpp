/// \file
/// A cursor over a file's bytes. It reads words, numbers and raw binary values, and names the place of every
/// fault: file, line (byte for binary parts) and the element being read.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "unsliver/error.hpp"
#include "unsliver/types.hpp"

namespace unsliver::io {

/// Whether the words of one row may go on over line ends, or must lie on one line.
enum class Layout { kFree, kLines };

struct Dialect {
  char comment = '\0';       ///< starts a comment that lasts to the end of its line; '\0' = there are none
  char continuation = '\0';  ///< as the last character of a line joins it with the next; '\0' = there is none
  Layout layout = Layout::kFree;
};

class Scanner {
 public:
  /// `bytes` must outlive the scanner. `name` is the file's name for messages. A UTF-8 mark is skipped.
  Scanner(std::string_view bytes, std::string name, Dialect dialect = {});

  /// Names the element being read: later faults carry its kind and its number (the file's own numbering).
  void at(std::string_view element, std::uint64_t number) {
    element_ = element;
    element_number_ = number;
  }
  /// No element is being read.
  void at_none() { element_ = {}; }

  // Text. `what` names the expected thing in the message of a fault: "a coordinate".

  /// Skips white space, line ends and comments; true when nothing is left.
  bool at_end();
  /// Skips white space and a comment on the current line; true when nothing is left on it.
  bool at_line_end();
  /// Skips empty lines and comments. Error kFormat when the file ends.
  void next_line(std::string_view what);
  void skip_line();
  /// The rest of the current line without its end; goes on to the next one.
  std::string_view line();
  /// The next word. Error kFormat when the file, or (Layout::kLines) the line, ends.
  std::string_view word(std::string_view what);
  /// Reads one word and checks that it is `expected`, in any case of letters.
  void keyword(std::string_view expected);
  /// The word that would come next, without reading it; empty at the end.
  std::string_view peek();
  /// A finite number. Error kFormat when it is none, kBadInput when it is NaN or infinite.
  double number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// The finite number, or the integer, that `word`, part of what was read last, stands for.
  double to_number(std::string_view word, std::string_view what) const;
  std::int64_t to_integer(std::string_view word, std::string_view what) const;
  /// An integer that fits 32 bits.
  std::int32_t label(std::string_view what);
  /// A number of rows of at least `bytes_each` bytes that must still follow: see require_room.
  std::size_t count(std::string_view what, std::size_t bytes_each);

  // Binary.

  /// From here on the file is binary: places are given in bytes.
  void set_binary(std::endian order) {
    binary_ = true;
    swap_ = order != std::endian::native;
  }
  bool binary() const { return binary_; }
  /// The next `size` bytes. Error kFormat when fewer are left.
  std::string_view take(std::size_t size, std::string_view what);
  template <class T>
  T raw(std::string_view what);

  // Checks.

  /// Error kFormat unless `rows` >= 0 rows of at least `bytes_each` > 0 bytes can lie in the bytes left. To
  /// be asked before memory for declared rows is taken.
  std::size_t require_room(std::int64_t rows, std::size_t bytes_each, std::string_view what) const;
  /// Error kBadInput unless `value` is finite.
  double require_finite(double value, std::string_view what) const;
  /// `index` counted from `first` as a vertex of `vertex_count`. Error kBadInput when it is none of them.
  VertexId require_vertex(std::int64_t index, std::int64_t first, std::size_t vertex_count) const;

  /// Throws an Error whose message starts with the place of the word or value read last.
  [[noreturn]] void fail_here(ErrorCode code, const std::string& message) const;

  std::size_t offset() const { return position_; }
  void seek(std::size_t offset) { position_ = token_ = offset; }
  std::size_t bytes_left() const { return bytes_.size() - position_; }
  std::string_view rest() const { return bytes_.substr(position_); }
  const std::string& name() const { return name_; }

 private:
  void skip_blanks();
  std::size_t continuation_size() const;
  [[noreturn]] void fail_at_end(std::string_view what) const;

  std::string_view bytes_;
  std::string name_;
  Dialect dialect_;
  std::size_t position_ = 0;
  std::size_t token_ = 0;  // start of the word or value read last
  std::string_view element_;
  std::uint64_t element_number_ = 0;
  bool binary_ = false;
  bool swap_ = false;
};

/// Is the word written as a number, "nan" and "inf" included?
bool is_number(std::string_view word);

/// A word as it may stand in a message: short, printable and in quotes.
std::string in_quotes(std::string_view word);

/// `value` with its bytes in reverse order.
template <class T>
T byte_swapped(T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <class T>
T Scanner::raw(std::string_view what) {
  T value;
  std::memcpy(&value, take(sizeof(T), what).data(), sizeof(T));
  return swap_ ? byte_swapped(value) : value;
}

/// Reads three numbers.
inline Vec3 read_point(Scanner& scanner) {
  const double x = scanner.number("coordinate x");
  const double y = scanner.number("coordinate y");
  const double z = scanner.number("coordinate z");
  return {x, y, z};
}

}  // namespace unsliver::io
