/// \file
/// Gmsh .msh 2.2 and 4.1, text and binary. A label is the tag of a piece of geometry, and if it is positive,
/// of a physical group too. Meshes without labels lie on geometry 1 without a group.
#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "io/fail.hpp"
#include "io/msh_input.hpp"
#include "io/msh_output.hpp"
#include "io/msh_periodic.hpp"
#include "io/writers.hpp"
#include "unsliver/types.hpp"

namespace unsliver::io {
namespace {

constexpr std::int32_t kUnlabelled = 1;

/// Elements of one dimension in the order of their labels, with the ranges of equal labels.
struct LabelGroups {
  struct Group {
    std::int32_t label;
    bool is_physical;
    std::size_t begin, end;  // in `order`
  };
  std::vector<std::uint32_t> order;
  std::vector<Group> groups;
};

LabelGroups group_by_label(std::size_t count, const std::vector<std::int32_t>& labels) {
  LabelGroups result;
  result.order.resize(count);
  std::iota(result.order.begin(), result.order.end(), 0u);
  if (labels.empty()) {
    if (count > 0) result.groups.push_back({kUnlabelled, false, 0, count});
    return result;
  }
  std::stable_sort(result.order.begin(), result.order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return labels[a] < labels[b]; });
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t label = labels[result.order[i]];
    if (i == 0 || label != result.groups.back().label) result.groups.push_back({label, label > 0, i, i});
    result.groups.back().end = i + 1;
  }
  return result;
}

/// The labels that become physical groups, ascending.
std::vector<std::int32_t> physical_labels(const LabelGroups& groups) {
  std::vector<std::int32_t> labels;
  for (const auto& group : groups.groups)
    if (group.is_physical) labels.push_back(group.label);
  return labels;
}

void write_physical_names(MshOutput& out, const LabelGroups& surfaces, const LabelGroups& volumes) {
  const std::vector<std::int32_t> labels = physical_labels(surfaces);
  const std::vector<std::int32_t> regions = physical_labels(volumes);
  if (labels.empty() && regions.empty()) return;
  out.begin("PhysicalNames");
  out.text_count(labels.size() + regions.size());
  for (const std::int32_t label : labels) out.text_line("2 ", label, " \"surface_", label, "\"");
  for (const std::int32_t region : regions) out.text_line("3 ", region, " \"region_", region, "\"");
  out.text_line("$EndPhysicalNames");
}

// Version 2.2: elements in their own order, each with its label.

void write_nodes_22(MshOutput& out, const TetMesh& mesh) {
  out.begin("Nodes");
  out.text_count(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out.integer(static_cast<std::int64_t>(i) + 1);
    for (int axis = 0; axis < 3; ++axis) out.real(mesh.points[i][axis]);
    out.end_row();
  }
  out.end("Nodes");
}

template <std::size_t N>
void write_elements_22(MshOutput& out, std::int64_t type, std::size_t first_tag,
                       const std::vector<std::array<VertexId, N>>& elements,
                       const std::vector<std::int32_t>& labels) {
  constexpr std::int64_t kTagCount = 2;
  if (!out.ascii() && !elements.empty()) {
    out.integer(type);
    out.integer(static_cast<std::int64_t>(elements.size()));
    out.integer(kTagCount);
  }
  for (std::size_t i = 0; i < elements.size(); ++i) {
    out.integer(static_cast<std::int64_t>(first_tag + i));
    if (out.ascii()) {
      out.integer(type);
      out.integer(kTagCount);
    }
    const std::int32_t label = labels.empty() ? kUnlabelled : labels[i];
    out.integer(labels.empty() ? 0 : std::max(label, 0));
    out.integer(label);
    for (const VertexId v : elements[i]) out.integer(std::int64_t{v} + 1);
    out.end_row();
  }
}

/// Row by row: the translation from the master to its copy.
std::array<double, 16> affine(const Vec3& moved) {
  return {1, 0, 0, moved.x, 0, 1, 0, moved.y, 0, 0, 1, moved.z, 0, 0, 0, 1};
}

/// Text in binary files too.
void write_periodic_22(MshOutput& out, const std::vector<PeriodicFaces>& faces) {
  if (faces.empty()) return;
  out.text_line("$Periodic");
  out.text_count(faces.size());
  for (const PeriodicFaces& face : faces) {
    out.text_line("2 ", face.label, " ", face.master);
    const auto a = affine(face.moved);
    out.text_line("Affine ", a[0], " ", a[1], " ", a[2], " ", a[3], " ", a[4], " ", a[5], " ", a[6], " ",
                  a[7], " ", a[8], " ", a[9], " ", a[10], " ", a[11], " ", a[12], " ", a[13], " ", a[14], " ",
                  a[15]);
    out.text_count(face.nodes.size());
    for (const auto& [node, master] : face.nodes)
      out.text_line(std::uint64_t{node} + 1, " ", std::uint64_t{master} + 1);
  }
  out.text_line("$EndPeriodic");
}

// Version 4.1: elements by entity.

void write_entity(MshOutput& out, const LabelGroups::Group& group, const Box3& box) {
  out.integer(group.label);
  for (const Vec3& corner : {box.lo, box.hi})
    for (int axis = 0; axis < 3; ++axis) out.real(corner[axis]);
  out.size(group.is_physical ? 1 : 0);
  if (group.is_physical) out.integer(group.label);
  out.size(0);  // bounding entities
  out.end_row();
}

void write_entities(MshOutput& out, const LabelGroups& surfaces, const LabelGroups& volumes,
                    const Box3& box) {
  out.begin("Entities");
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{0}, surfaces.groups.size(), volumes.groups.size()})
    out.size(count);
  out.end_row();
  for (const auto& group : surfaces.groups) write_entity(out, group, box);
  for (const auto& group : volumes.groups) write_entity(out, group, box);
  out.end("Entities");
}

void write_block_head(MshOutput& out, std::int64_t a, std::int64_t b, std::int64_t c, std::size_t count) {
  for (const std::int64_t value : {a, b, c}) out.integer(value);
  out.size(count);
  out.end_row();
}

void write_totals(MshOutput& out, std::size_t blocks, std::size_t count) {
  for (const std::size_t value : {blocks, count, std::size_t{count > 0}, count}) out.size(value);
  out.end_row();
}

void write_nodes_41(MshOutput& out, const TetMesh& mesh, const LabelGroups& volumes) {
  out.begin("Nodes");
  write_totals(out, 1, mesh.points.size());
  const std::int32_t entity = volumes.groups.empty() ? kUnlabelled : volumes.groups.front().label;
  write_block_head(out, 3, entity, 0, mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out.size(i + 1);
    out.end_row();
  }
  for (const Vec3& p : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) out.real(p[axis]);
    out.end_row();
  }
  out.end("Nodes");
}

template <std::size_t N>
void write_element_blocks(MshOutput& out, std::int64_t type, std::size_t first_tag, const LabelGroups& groups,
                          const std::vector<std::array<VertexId, N>>& elements) {
  for (const auto& group : groups.groups) {
    write_block_head(out, static_cast<std::int64_t>(N) - 1, group.label, type, group.end - group.begin);
    for (std::size_t i = group.begin; i < group.end; ++i) {
      out.size(first_tag + groups.order[i]);
      for (const VertexId v : elements[groups.order[i]]) out.size(std::uint64_t{v} + 1);
      out.end_row();
    }
  }
}

void write_periodic_41(MshOutput& out, const std::vector<PeriodicFaces>& faces) {
  if (faces.empty()) return;
  out.begin("Periodic");
  out.size(faces.size());
  out.end_row();
  for (const PeriodicFaces& face : faces) {
    for (const int value : {2, face.label, face.master}) out.integer(value);
    out.end_row();
    const auto a = affine(face.moved);
    out.size(a.size());
    for (const double value : a) out.real(value);
    out.end_row();
    out.size(face.nodes.size());
    out.end_row();
    for (const auto& [node, master] : face.nodes) {
      out.size(std::uint64_t{node} + 1);
      out.size(std::uint64_t{master} + 1);
      out.end_row();
    }
  }
  out.end("Periodic");
}

}  // namespace

void write_msh22(const std::filesystem::path& path, const TetMesh& mesh, bool ascii) {
  const std::size_t count = mesh.tets.size() + mesh.triangles.size();
  if (std::max(count, mesh.points.size()) > std::numeric_limits<std::int32_t>::max())
    fail(ErrorCode::kLimit, "'{}': Gmsh 2.2 cannot number so many elements; write format msh41",
         path.string());
  MshOutput out(path, "2.2", ascii);
  write_physical_names(out, group_by_label(mesh.triangles.size(), mesh.triangle_labels),
                       group_by_label(mesh.tets.size(), mesh.regions));
  write_nodes_22(out, mesh);
  out.begin("Elements");
  out.text_count(count);
  write_elements_22(out, kMshTetrahedron, 1, mesh.tets, mesh.regions);
  write_elements_22(out, kMshTriangle, mesh.tets.size() + 1, mesh.triangles, mesh.triangle_labels);
  out.end("Elements");
  write_periodic_22(out, periodic_faces(mesh));
  out.commit();
}

void write_msh41(const std::filesystem::path& path, const TetMesh& mesh, bool ascii) {
  const LabelGroups surfaces = group_by_label(mesh.triangles.size(), mesh.triangle_labels);
  const LabelGroups volumes = group_by_label(mesh.tets.size(), mesh.regions);
  Box3 box;
  for (const Vec3& p : mesh.points) box.extend(p);

  MshOutput out(path, "4.1", ascii);
  write_physical_names(out, surfaces, volumes);
  write_entities(out, surfaces, volumes, box);
  write_nodes_41(out, mesh, volumes);
  out.begin("Elements");
  write_totals(out, surfaces.groups.size() + volumes.groups.size(), mesh.tets.size() + mesh.triangles.size());
  write_element_blocks(out, kMshTriangle, mesh.tets.size() + 1, surfaces, mesh.triangles);
  write_element_blocks(out, kMshTetrahedron, 1, volumes, mesh.tets);
  out.end("Elements");
  write_periodic_41(out, periodic_faces(mesh));
  out.commit();
}

}  // namespace unsliver::io
