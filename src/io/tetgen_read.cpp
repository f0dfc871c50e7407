/// \file
/// TetGen .node, .ele, .face and .mtr. Numbering starts with 0 or 1, as the first node says.
#include <cmath>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/point_checks.hpp"
#include "io/polygons.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"
#include "io/tet_mesh_checks.hpp"

namespace unsliver::io {
namespace {

Scanner tetgen_scanner(std::string_view bytes, const std::string& name, std::string_view expected) {
  Scanner scanner(bytes, name, {.comment = '#', .layout = Layout::kLines});
  if (scanner.at_end()) fail_wrong_content(bytes, name, expected);
  return scanner;
}

// An optional integer on a header line.
std::int64_t integer_or(Scanner& scanner, std::int64_t otherwise, std::string_view what) {
  return scanner.at_line_end() ? otherwise : scanner.integer(what);
}

struct Nodes {
  std::vector<Vec3> points;
  std::int64_t first_index = 0;
};

void require_next_index(Scanner& scanner, std::int64_t expected) {
  const std::int64_t index = scanner.integer("an index");
  if (index != expected)
    scanner.fail_here(ErrorCode::kFormat, fmt::format("the row's index is {}, expected {}", index, expected));
}

Nodes read_nodes(std::string_view bytes, const std::string& name) {
  Scanner scanner = tetgen_scanner(bytes, name, "a TetGen .node file, which starts with '<count> 3 ...'");
  Nodes nodes;
  nodes.points.resize(scanner.count("nodes", sizeof("0 0 0 0")));
  require_numberable(nodes.points.size(), scanner);
  const std::int64_t dimension = integer_or(scanner, 3, "the dimension");
  if (dimension != 3)
    scanner.fail_here(ErrorCode::kUnsupported, fmt::format("the dimension is {}, not 3", dimension));
  scanner.skip_line();
  for (std::size_t i = 0; i < nodes.points.size(); ++i) {
    scanner.next_line("a node");
    if (i == 0) nodes.first_index = scanner.to_integer(scanner.peek(), "an index") == 1 ? 1 : 0;
    scanner.at("node", i + static_cast<std::size_t>(nodes.first_index));
    require_next_index(scanner, static_cast<std::int64_t>(i) + nodes.first_index);
    nodes.points[i] = read_point(scanner);
    scanner.skip_line();
  }
  return nodes;
}

// TetGen writes attributes as real numbers; a region is a whole one.
std::int32_t read_region(Scanner& scanner) {
  const double value = scanner.number("a region");
  if (value != std::trunc(value) || std::abs(value) > 2147483647.0)
    scanner.fail_here(ErrorCode::kBadInput, fmt::format("the region is {}, not a 32-bit integer", value));
  return static_cast<std::int32_t>(value);
}

template <std::size_t N>
std::array<VertexId, N> read_corners(Scanner& scanner, const Nodes& nodes) {
  std::array<VertexId, N> corners;
  for (VertexId& v : corners)
    v = scanner.require_vertex(scanner.integer("a node index"), nodes.first_index, nodes.points.size());
  return corners;
}

// Calls read() behind the index of each line.
template <class Read>
void for_each_element(Scanner& scanner, std::string_view kind, std::size_t count, const Nodes& nodes,
                      const Read& read) {
  const std::string one = fmt::format("a {}", kind);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at(kind, i + static_cast<std::size_t>(nodes.first_index));
    scanner.next_line(one);
    scanner.integer("an index");
    read();
    scanner.skip_line();
  }
}

void read_tets(std::string_view bytes, const std::string& name, const Nodes& nodes, TetMesh& mesh) {
  Scanner scanner = tetgen_scanner(bytes, name, "a TetGen .ele file, which starts with '<count> 4 ...'");
  const std::size_t count = scanner.count("tetrahedra", sizeof("0 0 0 0 0"));
  const std::int64_t corners = integer_or(scanner, 4, "the nodes of a tetrahedron");
  if (corners != 4)
    scanner.fail_here(ErrorCode::kUnsupported,
                      fmt::format("tetrahedra of {} nodes are not read; 4 are expected", corners));
  const bool has_region = integer_or(scanner, 0, "the number of attributes") > 0;
  scanner.skip_line();
  mesh.tets.reserve(count);
  for_each_element(scanner, "tetrahedron", count, nodes, [&] {
    mesh.tets.push_back(read_corners<4>(scanner, nodes));
    if (has_region) mesh.regions.push_back(read_region(scanner));
  });
}

void read_triangles(std::string_view bytes, const std::string& name, const Nodes& nodes, TetMesh& mesh) {
  Scanner scanner = tetgen_scanner(bytes, name, "a TetGen .face file, which starts with '<count> ...'");
  const std::size_t count = scanner.count("triangles", sizeof("0 0 0 0"));
  const bool has_label = integer_or(scanner, 0, "the number of markers") > 0;
  scanner.skip_line();
  mesh.triangles.reserve(count);
  for_each_element(scanner, "triangle", count, nodes, [&] {
    mesh.triangles.push_back(read_corners<3>(scanner, nodes));
    if (has_label) mesh.triangle_labels.push_back(scanner.label("a marker"));
  });
}

}  // namespace

TetMesh parse_tetgen(const TetgenBytes& bytes, const std::string& stem) {
  Nodes nodes = read_nodes(bytes.node, stem + ".node");
  TetMesh mesh;
  read_tets(bytes.ele, stem + ".ele", nodes, mesh);
  if (!bytes.face.empty()) read_triangles(bytes.face, stem + ".face", nodes, mesh);
  mesh.points = std::move(nodes.points);
  require_tets(mesh, stem + ".ele");
  return mesh;
}

PointSet parse_node(std::string_view bytes, const std::string& name) {
  PointSet set;
  set.points = read_nodes(bytes, name).points;
  require_points(set, name);
  return set;
}

std::vector<double> parse_mtr(std::string_view bytes, const std::string& name, std::size_t vertex_count) {
  Scanner scanner = tetgen_scanner(bytes, name, "a TetGen .mtr file, which starts with '<count> 1'");
  const std::size_t count = scanner.count("values", 2);
  if (count != vertex_count)
    scanner.fail_here(ErrorCode::kBadInput,
                      fmt::format("{} values are given for {} nodes", count, vertex_count));
  if (integer_or(scanner, 1, "the values of a node") != 1)
    scanner.fail_here(ErrorCode::kUnsupported, "one value a node is read; tensors are not");
  scanner.skip_line();
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("value", i);
    scanner.next_line("a value");
    values[i] = scanner.number("a size");
    scanner.skip_line();
  }
  return values;
}

}  // namespace unsliver::io
