/// \file
/// The structure of a VTU file: which arrays it has, where their bytes are and how those are encoded.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace unsliver::io {

enum class VtuFormat { kAscii, kBinary, kAppended };

struct VtuArray {
  std::string_view section;  ///< "Points", "Cells", "PointData", "CellData" or "FieldData"
  std::string_view name;
  std::string_view type;  ///< "Float64", "Int32", ...
  VtuFormat format = VtuFormat::kAscii;
  std::string_view text;     ///< content of the element: ASCII and inline binary
  std::uint64_t offset = 0;  ///< in the appended data
};

struct VtuPiece {
  std::uint64_t point_count = 0;  ///< as declared, unchecked
  std::uint64_t cell_count = 0;   ///< as declared, unchecked
  std::vector<VtuArray> arrays;

  /// The named array of a section, or its first when `name` is ""; nullptr when there is none.
  const VtuArray* find(std::string_view section, std::string_view name) const;
};

struct VtuDocument {
  std::string name;             ///< the file's, for messages
  bool swapped = false;         ///< byte order differs from this machine's
  std::size_t header_size = 4;  ///< bytes of the integers before binary data: 4 or 8
  bool compressed = false;      ///< zlib
  std::vector<VtuPiece> pieces;
  VtuPiece field_data;        ///< arrays outside any piece
  std::string_view appended;  ///< behind the '_'
  bool appended_is_base64 = false;

  /// The appended bytes from an array's start to the next array's start or the end.
  std::string_view appended_at(std::uint64_t offset) const;
};

/// Reads the tags. The views in the result are of `bytes`. Error kFormat or kUnsupported.
VtuDocument parse_vtu_document(std::string_view bytes, const std::string& name);

}  // namespace unsliver::io
