/// \file
/// Wavefront OBJ: the polygons of all groups and objects. Normals, texture coordinates, materials, lines and
/// curves are skipped.
#include <vector>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/polygons.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

class ObjParser {
 public:
  ObjParser(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name, {.comment = '#', .continuation = '\\', .layout = Layout::kLines}) {
    mesh_.name = name;
  }

  TriangleMesh parse() {
    while (!scanner_.at_end()) parse_line();
    check_forward_references();
    return std::move(mesh_);
  }

 private:
  // A face may name vertices that follow it; they can only be checked at the end.
  struct ForwardReference {
    std::size_t offset;
    std::size_t face;
    std::int64_t index;
  };

  void parse_line() {
    const std::string_view keyword = scanner_.word("a keyword");
    if (keyword == "v") parse_vertex();
    if (keyword == "f") parse_face();
    scanner_.skip_line();
  }

  void parse_vertex() {
    scanner_.at("vertex", mesh_.points.size() + 1);
    mesh_.points.push_back(read_point(scanner_));
    require_numberable(mesh_.points.size(), scanner_);
    scanner_.at_none();
  }

  void parse_face() {
    scanner_.at("face", ++face_);
    corners_.clear();
    while (!scanner_.at_line_end()) corners_.push_back(parse_corner());
    add_polygon(corners_, scanner_, mesh_);
    scanner_.at_none();
  }

  // "v", "v/vt", "v//vn" or "v/vt/vn"; v counts from 1, or back from the last vertex when negative.
  VertexId parse_corner() {
    const std::string_view word = scanner_.word("a corner");
    const std::int64_t index = scanner_.to_integer(word.substr(0, word.find('/')), "a vertex index");
    const auto known = static_cast<std::int64_t>(mesh_.points.size());
    if (index < 0) return resolve_negative(index, known);
    if (index > known && index < std::int64_t{kNoVertex}) {
      forward_.push_back({scanner_.offset() - word.size(), face_, index});
      return static_cast<VertexId>(index - 1);
    }
    return scanner_.require_vertex(index, 1, mesh_.points.size());
  }

  VertexId resolve_negative(std::int64_t index, std::int64_t known) {
    if (index < -known)
      scanner_.fail_here(
          ErrorCode::kBadInput,
          fmt::format("vertex index {} counts back past the {} vertices so far", index, known));
    return static_cast<VertexId>(known + index);
  }

  void check_forward_references() {
    for (const ForwardReference& reference : forward_) {
      scanner_.seek(reference.offset);
      scanner_.at("face", reference.face);
      scanner_.require_vertex(reference.index, 1, mesh_.points.size());
    }
  }

  Scanner scanner_;
  TriangleMesh mesh_;
  std::vector<VertexId> corners_;
  std::vector<ForwardReference> forward_;
  std::size_t face_ = 0;
};

}  // namespace

TriangleMesh parse_obj(std::string_view bytes, const std::string& name, Need need) {
  TriangleMesh mesh = ObjParser(bytes, name).parse();
  if (mesh.points.empty() && mesh.triangles.empty())
    fail_wrong_content(bytes, name, "an OBJ file with lines 'v x y z' and 'f i j k'");
  if (need == Need::kElements) require_triangles(mesh);
  return mesh;
}

}  // namespace unsliver::io
