#include "io/detect.hpp"

#include <algorithm>
#include <array>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

constexpr std::string_view kText = "some other text";

struct Signature {
  std::string_view start;
  std::string_view meaning;
};

// Longer and rarer starts first.
constexpr std::array kSignatures = {
    Signature{"\x1f\x8b", "a gzip archive; unpack it first"},
    Signature{"PK\x03\x04", "a zip archive; unpack it first"},
    Signature{"version https://git-lfs", "a Git LFS pointer, not the file itself"},
    Signature{"<VTKFile", "a VTK XML file"},
    Signature{"<?xml", "an XML file"},
    Signature{"<!DOCTYPE", "a web page"},
    Signature{"<html", "a web page"},
    Signature{"# vtk DataFile", "a legacy VTK file"},
    Signature{"$MeshFormat", "a Gmsh mesh"},
    Signature{"MeshVersionFormatted", "a MEDIT mesh"},
    Signature{"solid", "an STL file"},
    Signature{"ply", "a PLY file"},
    Signature{"OFF", "an OFF file"},
    Signature{"COFF", "an OFF file"},
};

std::string_view skip_leading_space(std::string_view bytes) {
  const auto first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view{} : bytes.substr(first);
}

/// That is not blank, cut where it is long.
std::string first_line(std::string_view bytes) {
  constexpr std::size_t kShown = 40;
  const std::string_view text = skip_leading_space(bytes);
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return line.size() <= kShown ? std::string(line) : std::string(line.substr(0, kShown)) + "...";
}

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return u < 0x20 && c != '\n' && c != '\r' && c != '\t';
  });
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string extension_of(const std::filesystem::path& path) { return lower_case(path.extension().string()); }

std::string_view guess_content(std::string_view bytes) {
  const std::string_view head = skip_leading_space(bytes.substr(0, 512));
  for (const Signature& signature : kSignatures)
    if (head.starts_with(signature.start)) return signature.meaning;
  return is_text(head) ? kText : "binary data";
}

void fail_wrong_content(std::string_view bytes, const std::string& name, std::string_view expected) {
  if (skip_leading_space(bytes).empty())
    fail(ErrorCode::kBadInput, "{}: the file is empty; expected {}", name, expected);
  const std::string_view guess = guess_content(bytes);
  const std::string start = guess == kText ? ", '" + first_line(bytes) + "'" : "";
  fail(ErrorCode::kFormat, "{}: expected {}; the content looks like {}{}", name, expected, guess, start);
}

}  // namespace unsliver::io
