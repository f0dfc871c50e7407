#include "io/ply_header.hpp"

#include <array>
#include <utility>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames{{
    {"char", PlyType::kInt8},
    {"uchar", PlyType::kUint8},
    {"short", PlyType::kInt16},
    {"ushort", PlyType::kUint16},
    {"int", PlyType::kInt32},
    {"uint", PlyType::kUint32},
    {"float", PlyType::kFloat32},
    {"double", PlyType::kFloat64},
    {"int8", PlyType::kInt8},
    {"uint8", PlyType::kUint8},
    {"int16", PlyType::kInt16},
    {"uint16", PlyType::kUint16},
    {"int32", PlyType::kInt32},
    {"uint32", PlyType::kUint32},
    {"float32", PlyType::kFloat32},
    {"float64", PlyType::kFloat64},
}};

PlyType parse_type(Scanner& scanner) {
  const std::string_view word = scanner.word("a type");
  for (const auto& [name, type] : kTypeNames)
    if (name == word) return type;
  scanner.fail_here(ErrorCode::kFormat, fmt::format("'{}' is not a type of PLY", word.substr(0, 40)));
}

PlyProperty parse_property(Scanner& scanner) {
  PlyProperty property{};
  if (scanner.peek() == "list") {
    scanner.word("list");
    property.count_type = parse_type(scanner);
  }
  property.type = parse_type(scanner);
  property.name = scanner.word("a property name");
  return property;
}

PlyElement parse_element(Scanner& scanner) {
  PlyElement element;
  element.name = scanner.word("an element name");
  const std::int64_t count = scanner.integer("the number of rows");
  if (count < 0) scanner.fail_here(ErrorCode::kFormat, fmt::format("the number of rows is {}", count));
  element.count = static_cast<std::size_t>(count);
  return element;
}

// The order of the bytes, or nothing for text.
std::optional<std::endian> parse_format(Scanner& scanner) {
  const std::string_view word = scanner.word("a format");
  if (word == "ascii") return std::nullopt;
  if (word == "binary_little_endian") return std::endian::little;
  if (word == "binary_big_endian") return std::endian::big;
  scanner.fail_here(ErrorCode::kFormat,
                    "the format must be ascii, binary_little_endian or binary_big_endian");
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return std::nullopt;
}

std::size_t PlyElement::shortest_row(bool binary) const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += binary ? size_of(p.count_type.value_or(p.type)) : 2;
  return size;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  for (const PlyElement& candidate : elements)
    if (candidate.name == element) return &candidate;
  return nullptr;
}

PlyHeader parse_ply_header(Scanner& scanner) {
  PlyHeader header;
  std::optional<std::endian> order;
  bool has_format = false;
  scanner.keyword("ply");
  while (true) {
    scanner.skip_line();
    scanner.next_line("'end_header'");
    const std::string_view word = scanner.word("a header line");
    if (word == "end_header") break;
    if (word == "format") {
      order = parse_format(scanner);
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(parse_element(scanner));
    } else if (word == "property") {
      if (header.elements.empty())
        scanner.fail_here(ErrorCode::kFormat, "a property stands before any element");
      header.elements.back().properties.push_back(parse_property(scanner));
    } else if (word != "comment" && word != "obj_info") {
      scanner.fail_here(ErrorCode::kFormat, fmt::format("unknown header line '{}'", word.substr(0, 40)));
    }
  }
  if (!has_format) scanner.fail_here(ErrorCode::kFormat, "the header has no format line");
  scanner.skip_line();
  if (order) scanner.set_binary(*order);
  return header;
}

}  // namespace unsliver::io
