/// \file
/// The header of a PLY file: which elements follow, how many, with which properties.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/scanner.hpp"

namespace unsliver::io {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Bytes of a value in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string_view name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< set for lists: the type of their length
};

struct PlyElement {
  std::string_view name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Position of the named property; nothing when there is none.
  std::optional<std::size_t> find(std::string_view property) const;
  /// The least bytes a row can take.
  std::size_t shortest_row(bool binary) const;
};

struct PlyHeader {
  std::vector<PlyElement> elements;

  /// The first element of that name; nullptr when there is none.
  const PlyElement* find(std::string_view element) const;
};

/// Reads up to and including end_header, and sets the scanner to binary where the format is. The views in the
/// result are of the scanned bytes.
PlyHeader parse_ply_header(Scanner& scanner);

}  // namespace unsliver::io
