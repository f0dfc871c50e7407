#include "io/vtu_document.hpp"

#include <algorithm>
#include <bit>
#include <charconv>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/xml.hpp"

namespace unsliver::io {
namespace {

constexpr std::string_view kSections[] = {"Points", "Cells", "PointData", "CellData", "FieldData"};

class DocumentParser {
 public:
  DocumentParser(std::string_view bytes, const std::string& name) : xml_(bytes, name) {
    document_.name = name;
  }

  VtuDocument parse() {
    XmlTag tag;
    while (xml_.next(tag)) {
      if (tag.name == "AppendedData" && !tag.closes) {
        parse_appended(tag);
        return std::move(document_);
      }
      if (tag.closes)
        close(tag);
      else
        open(tag);
    }
    if (!closed_) xml_.fail_here("the file ends before </VTKFile>; it is truncated");
    return std::move(document_);
  }

 private:
  void open(const XmlTag& tag) {
    if (tag.name == "VTKFile") parse_root(tag);
    if (tag.name == "Piece") parse_piece(tag);
    if (tag.name == "DataArray") parse_array(tag);
    if (std::find(std::begin(kSections), std::end(kSections), tag.name) != std::end(kSections))
      section_ = tag.closes_itself ? std::string_view{} : tag.name;
  }

  void close(const XmlTag& tag) {
    if (tag.name == section_) section_ = {};
    if (tag.name == "VTKFile") closed_ = true;
  }

  void parse_root(const XmlTag& tag) {
    if (tag.find("type") != "UnstructuredGrid")
      fail(ErrorCode::kUnsupported, "{}: the VTK file is of type '{}'; 'UnstructuredGrid' is read",
           document_.name, tag.find("type").value_or("").substr(0, 40));
    const bool is_big = tag.find("byte_order") == "BigEndian";
    document_.swapped = is_big != (std::endian::native == std::endian::big);
    document_.header_size = tag.find("header_type") == "UInt64" ? 8 : 4;
    const std::string_view compressor = tag.find("compressor").value_or("");
    document_.compressed = !compressor.empty();
    if (document_.compressed && compressor != "vtkZLibDataCompressor")
      fail(ErrorCode::kUnsupported, "{}: compressor '{}' is not read; use zlib or none", document_.name,
           compressor.substr(0, 40));
  }

  void parse_piece(const XmlTag& tag) {
    VtuPiece& piece = document_.pieces.emplace_back();
    piece.point_count = integer_attribute(tag, "NumberOfPoints");
    piece.cell_count = integer_attribute(tag, "NumberOfCells");
  }

  void parse_array(const XmlTag& tag) {
    VtuArray array;
    array.section = section_;
    array.name = tag.find("Name").value_or("");
    array.type = tag.find("type").value_or("");
    array.format = parse_format(tag);
    if (array.format == VtuFormat::kAppended)
      array.offset = integer_attribute(tag, "offset");
    else if (!tag.closes_itself)
      array.text = xml_.text();
    const bool in_piece = section_ != "FieldData" && !document_.pieces.empty();
    (in_piece ? document_.pieces.back() : document_.field_data).arrays.push_back(array);
  }

  VtuFormat parse_format(const XmlTag& tag) const {
    const std::string_view format = tag.find("format").value_or("ascii");
    if (format == "ascii") return VtuFormat::kAscii;
    if (format == "binary") return VtuFormat::kBinary;
    if (format == "appended") return VtuFormat::kAppended;
    xml_.fail_here("the format of a DataArray must be ascii, binary or appended");
  }

  void parse_appended(const XmlTag& tag) {
    document_.appended_is_base64 = tag.find("encoding") == "base64";
    const std::string_view rest = xml_.rest();
    const std::size_t mark = rest.find_first_not_of(" \t\r\n");
    if (mark == std::string_view::npos || rest[mark] != '_')
      xml_.fail_here("the appended data does not start with '_'");
    document_.appended = rest.substr(mark + 1);
    if (document_.appended_is_base64)
      document_.appended = document_.appended.substr(0, document_.appended.find('<'));
  }

  std::uint64_t integer_attribute(const XmlTag& tag, std::string_view attribute) const {
    const std::string_view text = tag.find(attribute).value_or("");
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      xml_.fail_here(
          fmt::format("attribute '{}' of '{}' is not a number", attribute, tag.name.substr(0, 40)));
    return value;
  }

  XmlReader xml_;
  VtuDocument document_;
  std::string_view section_;
  bool closed_ = false;
};

}  // namespace

const VtuArray* VtuPiece::find(std::string_view section, std::string_view name) const {
  for (const VtuArray& array : arrays)
    if (array.section == section && (name.empty() || array.name == name)) return &array;
  return nullptr;
}

std::string_view VtuDocument::appended_at(std::uint64_t offset) const {
  if (offset > appended.size()) return {};
  std::uint64_t end = appended.size();
  const auto shorten = [&](const VtuPiece& piece) {
    for (const VtuArray& array : piece.arrays)
      if (array.format == VtuFormat::kAppended && array.offset > offset) end = std::min(end, array.offset);
  };
  for (const VtuPiece& piece : pieces) shorten(piece);
  shorten(field_data);
  return appended.substr(offset, end - offset);
}

VtuDocument parse_vtu_document(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, 4096).find("<VTKFile") == std::string_view::npos)
    fail_wrong_content(bytes, name, "a VTU file, which has '<VTKFile' at its start");
  return DocumentParser(bytes, name).parse();
}

}  // namespace unsliver::io
