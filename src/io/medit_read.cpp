/// \file
/// MEDIT .mesh and .sol, text. A file is a sequence of keywords, each with a count and that many rows;
/// unknown ones are skipped up to the next keyword.
#include <cctype>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/polygons.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"
#include "io/tet_mesh_checks.hpp"

namespace unsliver::io {
namespace {

constexpr std::size_t kShortestVertex = sizeof("0 0 0 0");

Scanner medit_scanner(std::string_view bytes, const std::string& name) {
  Scanner scanner(bytes, name, {.comment = '#'});
  if (lower_case(scanner.peek()) != "meshversionformatted")
    fail_wrong_content(bytes, name, "a MEDIT text file, which starts with 'MeshVersionFormatted'");
  scanner.word("MeshVersionFormatted");
  scanner.integer("the version");
  return scanner;
}

void require_dimension_3(Scanner& scanner) {
  const std::int64_t dimension = scanner.integer("the dimension");
  if (dimension != 3)
    scanner.fail_here(ErrorCode::kUnsupported, fmt::format("the dimension is {}, not 3", dimension));
}

bool is_keyword(std::string_view word) { return std::isalpha(static_cast<unsigned char>(word[0])) != 0; }

void skip_section(Scanner& scanner) {
  while (!scanner.at_end() && !is_keyword(scanner.peek())) scanner.word("a number");
}

void read_vertices(Scanner& scanner, TetMesh& mesh) {
  if (!mesh.points.empty()) scanner.fail_here(ErrorCode::kFormat, "a second section 'Vertices'");
  mesh.points.resize(scanner.count("vertices", kShortestVertex));
  require_numberable(mesh.points.size(), scanner);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    scanner.at("vertex", i + 1);
    mesh.points[i] = read_point(scanner);
    scanner.word("a reference");
  }
}

template <std::size_t N>
void read_elements(Scanner& scanner, std::string_view kind, std::size_t vertex_count,
                   std::vector<std::array<VertexId, N>>& elements, std::vector<std::int32_t>& labels) {
  const std::size_t count = scanner.count("elements", 2 * (N + 1));
  elements.reserve(elements.size() + count);
  labels.reserve(labels.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at(kind, i + 1);
    auto& element = elements.emplace_back();
    for (VertexId& v : element)
      v = scanner.require_vertex(scanner.integer("a vertex index"), 1, vertex_count);
    labels.push_back(scanner.label("a reference"));
  }
}

// References of 0 everywhere stand for "no regions".
void drop_if_all_zero(std::vector<std::int32_t>& labels) {
  for (const std::int32_t label : labels)
    if (label != 0) return;
  labels.clear();
}

}  // namespace

TetMesh parse_medit(std::string_view bytes, const std::string& name, Need need) {
  Scanner scanner = medit_scanner(bytes, name);
  TetMesh mesh;
  while (!scanner.at_end()) {
    scanner.at_none();
    const std::string keyword = lower_case(scanner.word("a keyword"));
    if (keyword == "end") break;
    if (keyword == "dimension")
      require_dimension_3(scanner);
    else if (keyword == "vertices")
      read_vertices(scanner, mesh);
    else if (keyword == "tetrahedra")
      read_elements(scanner, "tetrahedron", mesh.points.size(), mesh.tets, mesh.regions);
    else if (keyword == "triangles")
      read_elements(scanner, "triangle", mesh.points.size(), mesh.triangles, mesh.triangle_labels);
    else if (is_keyword(keyword))
      skip_section(scanner);
    else
      scanner.fail_here(ErrorCode::kFormat,
                        fmt::format("expected a keyword, found '{}'", keyword.substr(0, 40)));
  }
  if (need == Need::kElements) require_tets(mesh, name);
  drop_if_all_zero(mesh.regions);
  drop_if_all_zero(mesh.triangle_labels);
  return mesh;
}

std::vector<double> parse_sol(std::string_view bytes, const std::string& name, std::size_t vertex_count) {
  Scanner scanner = medit_scanner(bytes, name);
  while (lower_case(scanner.peek()) != "solatvertices") {
    if (lower_case(scanner.word("SolAtVertices")) == "dimension")
      require_dimension_3(scanner);
    else
      skip_section(scanner);
  }
  scanner.word("SolAtVertices");
  const std::size_t count = scanner.count("values", 2);
  if (count != vertex_count)
    scanner.fail_here(ErrorCode::kBadInput,
                      fmt::format("{} values are given for {} vertices", count, vertex_count));
  if (scanner.integer("the number of fields") != 1 || scanner.integer("the kind of field") != 1)
    scanner.fail_here(ErrorCode::kUnsupported,
                      "one scalar field ('1 1') is read; vectors and tensors are not");
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("value", i + 1);
    values[i] = scanner.number("a size");
  }
  return values;
}

}  // namespace unsliver::io
