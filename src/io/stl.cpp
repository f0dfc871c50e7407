/// \file
/// STL, ASCII and binary. A binary file may start with "solid" too, and its size tells it from text.
#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/point_merger.hpp"
#include "io/polygons.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFirstFacet = kHeaderSize + 4;
constexpr std::size_t kNormalSize = 12;
constexpr std::size_t kAttributeSize = 2;
constexpr std::size_t kFacetSize = 4 * 12 + kAttributeSize;

std::uint32_t declared_facets(std::string_view bytes, const std::string& name) {
  Scanner scanner(bytes, name);
  scanner.set_binary(std::endian::little);
  scanner.seek(kHeaderSize);
  return scanner.raw<std::uint32_t>("the number of facets");
}

bool has_binary_size(std::string_view bytes, const std::string& name) {
  return bytes.size() >= kFirstFacet &&
         bytes.size() == kFirstFacet + kFacetSize * std::uint64_t{declared_facets(bytes, name)};
}

bool starts_as_text(std::string_view bytes, const std::string& name) {
  const std::string word = lower_case(Scanner(bytes, name).peek().substr(0, 5));
  // Text has no zero bytes; a binary file has them in its first facets at the latest.
  const bool has_zero_byte = bytes.substr(0, 1024).find('\0') != std::string_view::npos;
  return (word == "solid" || word == "facet") && !has_zero_byte;
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& name) {
  Scanner scanner(bytes, name);
  scanner.set_binary(std::endian::little);
  scanner.take(kHeaderSize, "the header");
  const std::uint32_t declared = scanner.raw<std::uint32_t>("the number of facets");
  const std::size_t count = scanner.require_room(declared, kFacetSize, "facets of 50 bytes");

  PointMerger points;
  std::vector<std::array<VertexId, 3>> triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("facet", i);
    scanner.take(kNormalSize, "a normal");
    for (VertexId& corner : triangles[i]) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = scanner.require_finite(scanner.raw<float>("a corner"), "a coordinate");
      corner = points.add(p);
    }
    scanner.take(kAttributeSize, "an attribute");
  }
  return {points.take_points(), std::move(triangles), name};
}

// From after "facet" to "endfacet". Normals are not read: exporters write nan there.
std::array<VertexId, 3> parse_facet(Scanner& scanner, PointMerger& points) {
  scanner.keyword("normal");
  for (int i = 0; i < 3; ++i) scanner.word("a normal");
  scanner.keyword("outer");
  scanner.keyword("loop");
  std::array<VertexId, 3> triangle;
  for (VertexId& corner : triangle) {
    scanner.keyword("vertex");
    corner = points.add(read_point(scanner));
  }
  scanner.keyword("endloop");
  scanner.keyword("endfacet");
  return triangle;
}

TriangleMesh parse_ascii(std::string_view bytes, const std::string& name) {
  Scanner scanner(bytes, name);
  PointMerger points;
  std::vector<std::array<VertexId, 3>> triangles;
  bool complete = true;
  while (!scanner.at_end()) {
    const std::string word = lower_case(scanner.peek().substr(0, 9));
    if (word == "solid" || word == "endsolid") {
      scanner.skip_line();
      complete = word == "endsolid";
      continue;
    }
    scanner.at("facet", triangles.size());
    scanner.keyword("facet");
    triangles.push_back(parse_facet(scanner, points));
    scanner.at_none();
  }
  if (!complete) scanner.keyword("endsolid");
  return {points.take_points(), std::move(triangles), name};
}

TriangleMesh parse_either(std::string_view bytes, const std::string& name) {
  if (has_binary_size(bytes, name)) return parse_binary(bytes, name);
  if (starts_as_text(bytes, name)) return parse_ascii(bytes, name);
  if (bytes.size() < kFirstFacet)
    fail_wrong_content(bytes, name,
                       "an STL file: text that starts with 'solid', or at least 84 binary bytes");
  return parse_binary(bytes, name);
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name, Need need) {
  TriangleMesh mesh = parse_either(bytes, name);
  if (need == Need::kElements) require_triangles(mesh);
  return mesh;
}

}  // namespace unsliver::io
