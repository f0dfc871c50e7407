/// \file
/// The little XML that VTK files need: tags with attributes and the text behind them, one after another.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unsliver::io {

struct XmlTag {
  std::string_view name;
  bool closes = false;         ///< </name>
  bool closes_itself = false;  ///< <name/>
  std::vector<std::pair<std::string_view, std::string_view>> attributes;

  /// The attribute's value; nothing when it is absent.
  std::optional<std::string_view> find(std::string_view attribute) const;
};

/// Walks over the tags of `bytes`; declarations and comments are skipped. Entities are left as they stand.
class XmlReader {
 public:
  /// `bytes` must outlive the reader and its tags.
  XmlReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  /// Moves to the next tag; false at the end. Error kFormat for a tag that does not end.
  bool next(XmlTag& tag);
  /// The text from the tag read last to the next '<'.
  std::string_view text() const;
  /// All bytes behind the tag read last.
  std::string_view rest() const { return bytes_.substr(position_); }

  /// Throws a kFormat Error that starts with the line of the tag read last.
  [[noreturn]] void fail_here(std::string_view message) const;

 private:
  void parse_attributes(std::string_view text, XmlTag& tag) const;

  std::string_view bytes_;
  std::string name_;
  std::size_t tag_start_ = 0;
  std::size_t position_ = 0;
};

}  // namespace unsliver::io
