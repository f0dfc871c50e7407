#include "raw_manifest.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mesh_report.hpp"
#include "unsliver/error.hpp"

namespace unsliver::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "unsliver raw mesh";
constexpr int kVersion = 1;
constexpr const char* kByteOrder = std::endian::native == std::endian::little ? "little" : "big";
/// Offsets into files are 63-bit numbers.
constexpr std::uint64_t kMostTets = std::uint64_t{1} << 58;

Json file_json(const RawArray& array, std::uint64_t items) {
  return {{"name", array.name},
          {"type", array.type},
          {"shape", {items, array.components}},
          {"bytes", items * array.bytes}};
}

/// JSON has no infinity: what bounds nothing is null.
Json limits_json(const QualityLimits& limits) {
  Json json{{"min_dihedral_deg", limits.min_dihedral_deg},
            {"max_dihedral_deg", limits.max_dihedral_deg},
            {"max_radius_edge", nullptr}};
  if (std::isfinite(limits.max_radius_edge)) json["max_radius_edge"] = limits.max_radius_edge;
  return json;
}

QualityLimits limits_of(const Json& json) {
  QualityLimits limits{json.at("min_dihedral_deg").get<double>(), json.at("max_dihedral_deg").get<double>()};
  if (const Json& ratio = json.at("max_radius_edge"); !ratio.is_null())
    limits.max_radius_edge = ratio.get<double>();
  return limits;
}

std::uint64_t count_of(const Json& json, const char* name, std::uint64_t most) {
  const Json& count = json.at(name);
  if (!count.is_number_unsigned() || count.get<std::uint64_t>() > most)
    throw Error(ErrorCode::kFormat,
                fmt::format("\"{}\" is {}: expected a whole number, {} at most", name, count.dump(), most));
  return count.get<std::uint64_t>();
}

Frame frame_of(const Json& json) {
  const auto origin = json.at("origin").get<std::array<double, 3>>();
  const Frame frame{json.at("unit").get<double>(), {origin[0], origin[1], origin[2]}};
  if (!(frame.unit > 0) || !std::isfinite(frame.unit) || !is_finite(frame.origin))
    throw Error(ErrorCode::kFormat, "\"frame\" needs a positive unit and finite numbers");
  return frame;
}

void check_kind(const Json& json) {
  if (json.at("format").get<std::string>() != kFormat)
    throw Error(ErrorCode::kFormat, fmt::format("\"format\" is not \"{}\"", kFormat));
  if (json.at("version") != kVersion)
    throw Error(ErrorCode::kUnsupported,
                fmt::format("version {} is not known here, only {}", json.at("version").dump(), kVersion));
  if (json.at("byte_order") != kByteOrder)
    throw Error(ErrorCode::kUnsupported, fmt::format("the byte order is {}, this machine's is {}",
                                                     json.at("byte_order").dump(), kByteOrder));
}

RawManifest manifest_of(const Json& json) {
  check_kind(json);
  RawManifest manifest;
  manifest.head.vertices = count_of(json, "vertices", kNoVertex);
  manifest.head.tets = count_of(json, "tets", kMostTets);
  manifest.head.frame = frame_of(json.at("frame"));
  if (const Json& limits = json.at("limits"); !limits.is_null()) manifest.limits = limits_of(limits);
  return manifest;
}

}  // namespace

std::string to_text(const RawManifest& manifest) {
  const MeshHead& head = manifest.head;
  const Json json{{"format", kFormat},
                  {"version", kVersion},
                  {"byte_order", kByteOrder},
                  {"vertices", head.vertices},
                  {"tets", head.tets},
                  {"frame", {{"unit", head.frame.unit}, {"origin", to_json(head.frame.origin)}}},
                  {"limits", manifest.limits ? limits_json(*manifest.limits) : Json(nullptr)},
                  {"files",
                   {{"points", file_json(kRawPoints, head.vertices)},
                    {"levels", file_json(kRawLevels, head.vertices)},
                    {"tets", file_json(kRawTets, head.tets)}}}};
  return json.dump(2) + "\n";
}

RawManifest parse_manifest(const std::string& text, const std::string& name) {
  try {
    return manifest_of(Json::parse(text));
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(ErrorCode::kFormat,
                fmt::format("{}: not the manifest of a mesh: no JSON at byte {}", name, error.byte));
  } catch (const nlohmann::json::exception& error) {
    throw Error(ErrorCode::kFormat, fmt::format("{}: not the manifest of a mesh: {}", name, error.what()));
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace unsliver::cli
