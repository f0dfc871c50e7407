#include "input_vertices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

#include "files.hpp"
#include "text.hpp"
#include "union_of_tets.hpp"
#include "unsliver/io.hpp"

namespace unsliver::cli {
namespace {

/// For sides of no length: the longest side, 1 where all points coincide, and never so little that it is lost
/// in the rounding of the coordinates.
double length_for_flat(const Box3& box) {
  constexpr double kLeastShare = 1e-9;
  double largest = 0;
  for (const Vec3& p : {box.lo, box.hi})
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::max(box.longest_side() > 0 ? box.longest_side() : 1, kLeastShare * largest);
}

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// Compares the inputs with the mesh, once in each direction.
class InputCheck {
 public:
  InputCheck(const TetMesh& mesh, const std::vector<Vec3>& inputs, VerifyReport& report)
      : mesh_(mesh), inputs_(inputs), report_(report) {}

  void run() {
    collect_named_vertices();
    std::sort(present_.begin(), present_.end(), lex_less);
    for (std::size_t i = 0; i < inputs_.size(); ++i)
      if (!std::binary_search(present_.begin(), present_.end(), inputs_[i], lex_less))
        find(i, inputs_[i], "is not a vertex of the mesh");
    report_.checks.push_back(fmt::format("inputs: {} are vertices of the mesh, at {} places{}",
                                         plural(inputs_.size(), "point"), with_separators(present_.size()),
                                         wrong_ == 0 ? ", bit for bit" : ": VIOLATED"));
  }

 private:
  void collect_named_vertices() {
    const std::vector<VertexId> used = used_vertices(mesh_);
    for (VertexId v = 0; v < mesh_.point_source.size(); ++v) {
      const std::int64_t source = mesh_.point_source[v];
      if (source < 0) continue;
      const auto id = static_cast<std::size_t>(source);
      if (id >= inputs_.size() || !same_bits(inputs_[id], mesh_.points[v]))
        find(id, mesh_.points[v], "is not where the mesh has it");
      else if (!std::binary_search(used.begin(), used.end(), v))
        find(id, mesh_.points[v], "is in no tetrahedron");
      else
        present_.push_back(mesh_.points[v]);
    }
  }

  void find(std::size_t id, const Vec3& p, const char* fault) {
    constexpr int kShown = 20;
    report_.ok = false;
    ++report_.finding_count;
    if (++wrong_ <= kShown)
      report_.findings.push_back({"input",
                                  fmt::format("input point {} at {} {}", id, point_text(p), fault),
                                  {static_cast<std::int64_t>(id)}});
  }

  const TetMesh& mesh_;
  const std::vector<Vec3>& inputs_;
  VerifyReport& report_;
  std::vector<Vec3> present_;
  int wrong_ = 0;
};

}  // namespace

InputVertices read_input_vertices(const std::string& path) {
  check_readable(path);
  return {path, io::read_points(path), {}};
}

Box3 box_with_volume(const std::vector<Vec3>& points, std::vector<std::string>& notes) {
  Box3 box;
  for (const Vec3& p : points) box.extend(p);
  const double length = length_for_flat(box);
  std::string axes;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lo[axis] < box.hi[axis]) continue;
    axes += fmt::format("{}{}", axes.empty() ? "" : ", ", "xyz"[axis]);
    box.lo[axis] -= 0.5 * length;
    box.hi[axis] += 0.5 * length;
  }
  if (!axes.empty())
    notes.push_back(fmt::format(
        "the points' bounding box has no volume: it was given a side of {:.6g} along {}", length, axes));
  return box;
}

void check_inputs(const TetMesh& mesh, const std::vector<Vec3>& inputs, VerifyReport& report) {
  InputCheck(mesh, inputs, report).run();
}

void restore_ids(const InputVertices& inputs, TetMesh& mesh) {
  if (inputs.ids.empty()) return;
  for (std::int64_t& source : mesh.point_source)
    if (source >= 0) source = inputs.ids[static_cast<std::size_t>(source)];
}

Error with_restored_ids(const InputVertices& inputs, const Error& error) {
  if (inputs.ids.empty() || error.ids.empty()) return error;
  std::vector<std::int64_t> restored;
  for (const std::int64_t id : error.ids) restored.push_back(inputs.ids.at(static_cast<std::size_t>(id)));
  Error told(error.code(),
             fmt::format("{} (In {}: {}.)", error.what(), inputs.file, fmt::join(restored, ", ")));
  told.ids = restored;
  told.places = error.places;
  return told;
}

}  // namespace unsliver::cli
