/// \file
/// The values of a Gmsh file, as text or binary.
#pragma once

#include "io/output.hpp"

namespace unsliver::io {

class MshOutput {
 public:
  MshOutput(const std::filesystem::path& path, std::string_view version, bool ascii);

  void begin(std::string_view section) { out_.print("$", section, "\n"); }
  void end(std::string_view section) { out_.print(ascii_ ? "" : "\n", "$End", section, "\n"); }
  void commit() { out_.commit(); }

  /// A count on a line of its own, as text in both kinds of file.
  void text_count(std::size_t count) { out_.print(count, "\n"); }
  /// A line of text.
  template <class... Items>
  void text_line(const Items&... items) {
    out_.print(items..., "\n");
  }

  /// An "int" of the format.
  void integer(std::int64_t value) { put(value, static_cast<std::int32_t>(value)); }
  /// A "size_t" of the format.
  void size(std::uint64_t value) { put(value, value); }
  void real(double value) { put(value, value); }
  /// Ends a row: in text, the line.
  void end_row() {
    if (ascii_) out_.put('\n');
    row_started_ = false;
  }
  bool ascii() const { return ascii_; }

 private:
  template <class Text, class Raw>
  void put(Text text, Raw raw) {
    if (!ascii_) return out_.put_raw(raw);
    if (row_started_) out_.put(' ');
    row_started_ = true;
    out_.put(text);
  }

  Output out_;
  bool ascii_;
  bool row_started_ = false;
};

}  // namespace unsliver::io
