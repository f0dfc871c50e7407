/// \file
/// Gmsh .msh 2 and 4.1, text and binary. A file is a sequence of sections $Name ... $EndName; those not
/// needed are skipped.
#include <map>
#include <vector>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/msh_builder.hpp"
#include "io/msh_input.hpp"
#include "io/readers.hpp"
#include "io/tet_mesh_checks.hpp"

namespace unsliver::io {
namespace {

class MshReader {
 public:
  MshReader(std::string_view bytes, const std::string& name) : in_(bytes, name) {}

  TetMesh read() {
    read_format();
    while (!in_.text().at_end()) read_section();
    return builder_.take_mesh();
  }

 private:
  void read_format() {
    Scanner& text = in_.text();
    text.keyword("$MeshFormat");
    const std::string_view version = text.word("a version");
    version4_ = version == "4.1";
    if (!version4_ && version != "2" && !version.starts_with("2."))
      text.fail_here(
          ErrorCode::kUnsupported,
          fmt::format("version {} is not read; save the mesh as 2.2 or 4.1", version.substr(0, 40)));
    const bool is_binary = text.integer("the file type") == 1;
    const std::int64_t data_size = text.integer("the size of a number");
    text.skip_line();
    if (is_binary) read_byte_order(data_size);
    skip_to_end_of("$MeshFormat");
  }

  // The integer 1 follows, in the order of the machine that wrote the file.
  void read_byte_order(std::int64_t data_size) {
    Scanner& text = in_.text();
    if (data_size != 8)
      text.fail_here(ErrorCode::kUnsupported,
                     fmt::format("numbers of {} bytes are not read, 8 are", data_size));
    text.set_binary(std::endian::native);
    if (text.raw<std::int32_t>("the byte order") != 1)
      text.set_binary(std::endian::native == std::endian::little ? std::endian::big : std::endian::little);
  }

  void read_section() {
    Scanner& text = in_.text();
    text.at_none();
    const std::string_view name = text.word("a section");
    if (!name.starts_with('$'))
      text.fail_here(ErrorCode::kFormat, fmt::format("expected a section like $Nodes, found '{}'",
                                                     std::string(name.substr(0, 20))));
    text.skip_line();
    if (name == "$Entities") read_entities();
    if (name == "$Nodes") version4_ ? read_nodes_4() : read_nodes_2();
    if (name == "$Elements") version4_ ? read_elements_4() : read_elements_2();
    skip_to_end_of(name);
  }

  void skip_to_end_of(std::string_view section) {
    Scanner& text = in_.text();
    text.at_none();
    const std::string mark = "$End" + std::string(section.substr(1));
    const std::size_t distance = text.rest().find(mark);
    if (distance == std::string_view::npos)
      text.fail_here(ErrorCode::kFormat,
                     fmt::format("the section has no {}; the file is truncated", mark.substr(0, 40)));
    text.seek(text.offset() + distance + mark.size());
    text.skip_line();
  }

  // In version 2 the counts are text even in binary files.
  std::size_t read_count_2(std::string_view what) {
    const std::size_t count = in_.text().count(what, in_.binary() ? 12 : 8);
    in_.text().skip_line();
    return count;
  }

  void read_nodes_2() {
    const std::size_t count = read_count_2("nodes");
    for (std::size_t i = 0; i < count; ++i) {
      in_.text().at("node", i + 1);
      const std::int64_t tag = in_.integer("a node tag");
      builder_.add_node(tag, in_.point());
    }
    builder_.finish_nodes(in_.text());
  }

  // In text each element states its type; in binary a group of elements does.
  void read_elements_2() {
    const std::size_t total = read_count_2("elements");
    for (std::size_t done = 0; done < total;) {
      in_.text().at("element", done + 1);
      if (!in_.binary()) in_.integer("an element tag");
      const std::int64_t type = in_.integer("an element type");
      const std::int64_t group = in_.binary() ? in_.integer("a group's size") : 1;
      const std::int64_t tag_count = in_.integer("the number of tags");
      if (group < 1 || static_cast<std::size_t>(group) > total - done)
        in_.text().fail_here(ErrorCode::kFormat,
                             fmt::format("a group of {} elements, {} are left", group, total - done));
      for (std::int64_t i = 0; i < group; ++i, ++done) {
        in_.text().at("element", done + 1);
        if (in_.binary()) in_.integer("an element tag");
        const MshLabels labels = read_labels_2(tag_count);
        read_element_nodes(type, labels, false);
      }
    }
  }

  MshLabels read_labels_2(std::int64_t tag_count) {
    MshLabels labels;
    for (std::int64_t i = 0; i < tag_count; ++i) {
      const std::int64_t tag = in_.integer("a tag");
      if (i == 0) labels.physical = tag;
      if (i == 1) labels.elementary = tag;
    }
    return labels;
  }

  void read_element_nodes(std::int64_t type, const MshLabels& labels, bool wide) {
    const auto tag = [&] { return wide ? in_.size("a node tag") : in_.integer("a node tag"); };
    const auto count = msh_node_count(type);
    if (!count)
      in_.text().fail_here(ErrorCode::kUnsupported, fmt::format("element type {} is not known", type));
    if (type == kMshTetrahedron) {
      builder_.add_tet(read_corners<4>(tag), labels, in_.text());
    } else if (type == kMshTriangle) {
      builder_.add_triangle(read_corners<3>(tag), labels, in_.text());
    } else {
      for (std::size_t i = 0; i < *count; ++i) tag();
    }
  }

  template <std::size_t N, class ReadTag>
  std::array<VertexId, N> read_corners(const ReadTag& read_tag) {
    std::array<VertexId, N> corners;
    for (VertexId& v : corners) v = builder_.vertex(read_tag(), in_.text());
    return corners;
  }

  void read_entities() {
    std::array<std::int64_t, 4> counts;
    for (std::int64_t& count : counts) count = in_.size("the number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) read_entity(dimension);
  }

  void read_entity(int dimension) {
    const std::int64_t tag = in_.integer("an entity tag");
    in_.skip_reals(dimension == 0 ? 3 : 6);
    const std::int64_t group_count = in_.size("the number of physical groups");
    for (std::int64_t i = 0; i < group_count; ++i) {
      const std::int64_t group = in_.integer("a physical group");
      if (i == 0) physical_[{dimension, tag}] = group;
    }
    if (dimension > 0) in_.skip_integers(in_.size("the number of bounding entities"));
  }

  void read_nodes_4() {
    const std::int64_t block_count = in_.size("the number of node blocks");
    for (int i = 0; i < 3; ++i) in_.size("a number");  // nodes, least and greatest tag
    for (std::int64_t block = 0; block < block_count; ++block) {
      in_.text().at("node block", static_cast<std::uint64_t>(block));
      read_node_block();
    }
    builder_.finish_nodes(in_.text());
  }

  void read_node_block() {
    const std::int64_t dimension = in_.integer("a dimension");
    in_.integer("an entity tag");
    const bool is_parametric = in_.integer("the parametric flag") != 0;
    std::vector<std::int64_t> tags(in_.require_rows(in_.size("the number of nodes"), 4, 32, "nodes"));
    for (std::int64_t& tag : tags) tag = in_.size("a node tag");
    for (const std::int64_t tag : tags) {
      builder_.add_node(tag, in_.point());
      if (is_parametric) in_.skip_reals(dimension);
    }
  }

  void read_elements_4() {
    const std::int64_t block_count = in_.size("the number of element blocks");
    for (int i = 0; i < 3; ++i) in_.size("a number");  // elements, least and greatest tag
    for (std::int64_t block = 0; block < block_count; ++block) {
      in_.text().at("element block", static_cast<std::uint64_t>(block));
      read_element_block();
    }
  }

  void read_element_block() {
    const std::int64_t dimension = in_.integer("a dimension");
    const std::int64_t entity = in_.integer("an entity tag");
    const std::int64_t type = in_.integer("an element type");
    const std::int64_t count = in_.size("the number of elements");
    const auto group = physical_.find({dimension, entity});
    const MshLabels labels{group == physical_.end() ? 0 : group->second, entity};
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t tag = in_.size("an element tag");
      in_.text().at("element", static_cast<std::uint64_t>(tag));
      read_element_nodes(type, labels, true);
    }
  }

  MshInput in_;
  MshBuilder builder_;
  bool version4_ = false;
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> physical_;  // by dimension and entity tag
};

}  // namespace

TetMesh parse_msh(std::string_view bytes, const std::string& name, Need need) {
  if (Scanner(bytes, name).peek() != "$MeshFormat")
    fail_wrong_content(bytes, name, "a Gmsh file, which starts with '$MeshFormat'");
  TetMesh mesh = MshReader(bytes, name).read();
  if (need == Need::kElements) require_tets(mesh, name);
  return mesh;
}

}  // namespace unsliver::io
