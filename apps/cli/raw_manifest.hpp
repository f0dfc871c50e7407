/// \file
/// manifest.json of a mesh that is a folder of plain arrays.
#pragma once

#include <optional>
#include <string>

#include "unsliver/mesh_sink.hpp"

namespace unsliver::cli {

/// Array files, one item after the other.
struct RawArray {
  const char* name;
  const char* type;   ///< of a component
  int components;     ///< of an item
  std::size_t bytes;  ///< of an item
};
inline constexpr RawArray kRawPoints{"points.f64", "f64", 3, sizeof(Vec3)};
inline constexpr RawArray kRawLevels{"levels.u8", "u8", 1, 1};
inline constexpr RawArray kRawTets{"tets.u32", "u32", 4, sizeof(std::array<VertexId, 4>)};

struct RawManifest {
  MeshHead head;
  std::optional<QualityLimits> limits;
};

std::string to_text(const RawManifest& manifest);

/// \throws Error kFormat, kUnsupported (another version, byte order); `name` is the file's, for messages.
RawManifest parse_manifest(const std::string& text, const std::string& name);

}  // namespace unsliver::cli
