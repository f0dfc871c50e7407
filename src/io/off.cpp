/// \file
/// OFF (Geomview), text. Colours, normals and texture coordinates behind the coordinates are skipped.
#include <vector>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/polygons.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

constexpr std::size_t kShortestVertex = sizeof("0 0 0");
constexpr std::size_t kShortestFace = sizeof("1 0");

bool is_off_header(std::string_view word) { return word.size() <= 7 && word.ends_with("OFF"); }

// The prefixes of Geomview: ST, C and N add data behind the coordinates, which is skipped; 4 and n change
// them.
void require_three_dimensions(Scanner& scanner, std::string_view header) {
  if (header.find_first_of("4n") != std::string_view::npos)
    scanner.fail_here(ErrorCode::kUnsupported,
                      fmt::format("'{}' has other than three coordinates; write it as OFF", header));
  if (!scanner.at_line_end() && scanner.peek() == "BINARY")
    scanner.fail_here(ErrorCode::kUnsupported, "binary OFF is not read; write it as text");
}

std::vector<Vec3> parse_vertices(Scanner& scanner, std::size_t count) {
  std::vector<Vec3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("vertex", i);
    scanner.next_line("a vertex");
    points[i] = read_point(scanner);
    scanner.skip_line();
  }
  return points;
}

void parse_faces(Scanner& scanner, std::size_t count, TriangleMesh& mesh) {
  std::vector<VertexId> corners;
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("face", i);
    scanner.next_line("a face");
    corners.resize(scanner.count("corners", 2));
    for (VertexId& corner : corners)
      corner = scanner.require_vertex(scanner.integer("a vertex index"), 0, mesh.points.size());
    add_polygon(corners, scanner, mesh);
    scanner.skip_line();
  }
}

}  // namespace

TriangleMesh parse_off(std::string_view bytes, const std::string& name, Need need) {
  Scanner scanner(bytes, name, {.comment = '#', .layout = Layout::kLines});
  if (!is_off_header(scanner.peek())) fail_wrong_content(bytes, name, "an OFF file, which starts with 'OFF'");
  require_three_dimensions(scanner, scanner.word("OFF"));

  scanner.next_line("the numbers of vertices and faces");
  const std::size_t vertices = scanner.count("vertices", kShortestVertex);
  require_numberable(vertices, scanner);
  const std::size_t faces = scanner.count("faces", kShortestFace);
  scanner.skip_line();

  TriangleMesh mesh{parse_vertices(scanner, vertices), {}, name};
  parse_faces(scanner, faces, mesh);
  if (need == Need::kElements) require_triangles(mesh);
  return mesh;
}

}  // namespace unsliver::io
