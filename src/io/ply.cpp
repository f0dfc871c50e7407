/// \file
/// PLY, text and binary. Only the vertices' x, y, z and the faces' vertex lists are kept.
#include <cmath>
#include <vector>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/ply_header.hpp"
#include "io/polygons.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

double read_binary_value(Scanner& scanner, PlyType type, std::string_view what) {
  switch (type) {
    case PlyType::kInt8:
      return scanner.raw<std::int8_t>(what);
    case PlyType::kUint8:
      return scanner.raw<std::uint8_t>(what);
    case PlyType::kInt16:
      return scanner.raw<std::int16_t>(what);
    case PlyType::kUint16:
      return scanner.raw<std::uint16_t>(what);
    case PlyType::kInt32:
      return scanner.raw<std::int32_t>(what);
    case PlyType::kUint32:
      return scanner.raw<std::uint32_t>(what);
    case PlyType::kFloat32:
      return scanner.raw<float>(what);
    case PlyType::kFloat64:
      return scanner.raw<double>(what);
  }
  return 0;
}

double read_value(Scanner& scanner, PlyType type, std::string_view what) {
  if (!scanner.binary()) return scanner.number(what);
  return scanner.require_finite(read_binary_value(scanner, type, what), what);
}

std::int64_t read_integer(Scanner& scanner, PlyType type, std::string_view what) {
  const double value = read_value(scanner, type, what);
  if (value != std::trunc(value) || std::abs(value) > 1e15)
    scanner.fail_here(ErrorCode::kFormat, fmt::format("{} is {}, not an integer", what, value));
  return static_cast<std::int64_t>(value);
}

std::size_t read_list_size(Scanner& scanner, const PlyProperty& list) {
  const std::int64_t size = read_integer(scanner, *list.count_type, "the length of a list");
  return scanner.require_room(size, scanner.binary() ? size_of(list.type) : 2, "list entries");
}

void skip_property(Scanner& scanner, const PlyProperty& property) {
  const std::size_t values = property.count_type ? read_list_size(scanner, property) : 1;
  if (scanner.binary()) {
    scanner.take(values * size_of(property.type), "a property");
  } else {
    for (std::size_t i = 0; i < values; ++i) scanner.word("a property");
  }
}

void skip_rows(Scanner& scanner, const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::size_t row = 0; row < element.count; ++row)
    for (const PlyProperty& property : element.properties) skip_property(scanner, property);
}

std::size_t require_rows(const Scanner& scanner, const PlyElement& element) {
  return scanner.require_room(static_cast<std::int64_t>(element.count),
                              element.shortest_row(scanner.binary()), element.name);
}

// For each property of the vertices the axis that it is, or -1.
std::vector<int> axes_of(const Scanner& scanner, const PlyElement& vertices) {
  std::vector<int> axes(vertices.properties.size(), -1);
  constexpr std::string_view kAxisNames[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto property = vertices.find(kAxisNames[axis]);
    if (!property || vertices.properties[*property].count_type)
      scanner.fail_here(ErrorCode::kFormat,
                        fmt::format("the vertices have no property '{}'", kAxisNames[axis]));
    axes[*property] = axis;
  }
  return axes;
}

std::vector<Vec3> read_vertices(Scanner& scanner, const PlyElement& element) {
  const std::vector<int> axes = axes_of(scanner, element);
  std::vector<Vec3> points(require_rows(scanner, element));
  require_numberable(points.size(), scanner);
  for (std::size_t i = 0; i < points.size(); ++i) {
    scanner.at("vertex", i);
    for (std::size_t p = 0; p < axes.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (axes[p] < 0)
        skip_property(scanner, property);
      else
        points[i][axes[p]] = read_value(scanner, property.type, "a coordinate");
    }
  }
  return points;
}

std::size_t corner_list_of(const Scanner& scanner, const PlyElement& faces) {
  auto list = faces.find("vertex_indices");
  if (!list) list = faces.find("vertex_index");
  if (!list || !faces.properties[*list].count_type)
    scanner.fail_here(ErrorCode::kFormat, "the faces have no list property 'vertex_indices'");
  return *list;
}

void read_faces(Scanner& scanner, const PlyElement& element, std::size_t vertex_count, TriangleMesh& mesh) {
  const std::size_t corner_list = corner_list_of(scanner, element);
  const std::size_t count = require_rows(scanner, element);
  std::vector<VertexId> corners;
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("face", i);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p != corner_list) {
        skip_property(scanner, property);
        continue;
      }
      corners.resize(read_list_size(scanner, property));
      for (VertexId& corner : corners)
        corner =
            scanner.require_vertex(read_integer(scanner, property.type, "a vertex index"), 0, vertex_count);
    }
    add_polygon(corners, scanner, mesh);
  }
}

void require_surface(const Scanner& scanner, const PlyHeader& header) {
  if (header.find("tristrips"))
    scanner.fail_here(ErrorCode::kUnsupported, "triangle strips are not read; write the surface with faces");
  if (!header.find("vertex") || !header.find("face"))
    scanner.fail_here(ErrorCode::kBadInput,
                      "the header declares no vertices or no faces; a surface is needed");
}

}  // namespace

TriangleMesh parse_ply(std::string_view bytes, const std::string& name, Need need) {
  if (!bytes.starts_with("ply")) fail_wrong_content(bytes, name, "a PLY file, which starts with 'ply'");
  Scanner scanner(bytes, name);
  const PlyHeader header = parse_ply_header(scanner);
  const PlyElement* vertices = header.find("vertex");
  const PlyElement* faces = header.find("face");
  if (need == Need::kElements) require_surface(scanner, header);
  if (!vertices) scanner.fail_here(ErrorCode::kBadInput, "the header declares no vertices");

  TriangleMesh mesh;
  mesh.name = name;
  for (const PlyElement& element : header.elements) {
    if (&element == vertices)
      mesh.points = read_vertices(scanner, element);
    else if (&element == faces)
      read_faces(scanner, element, vertices->count, mesh);
    else
      skip_rows(scanner, element);
    scanner.at_none();
  }
  if (need == Need::kElements) require_triangles(mesh);
  return mesh;
}

}  // namespace unsliver::io
