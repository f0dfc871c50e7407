#include "io/msh_periodic.hpp"

#include <map>

namespace unsliver::io {
namespace {

constexpr int kMiddle = periodic_face_label(0, 0, 0);
constexpr int kLast = periodic_face_label(1, 1, 1);

/// The points by vertex of the torus and shift.
class Copies {
 public:
  explicit Copies(const Periodicity& p) : p_(p) {
    for (VertexId v = 0; v < p.home.size(); ++v) ids_[{p.home[v], shift(v)}] = v;
  }
  /// Where v came from; kNoVertex if it is not there.
  VertexId moved_back(VertexId v, const std::array<int, 3>& by) const {
    std::array<int, 3> s = shift(v);
    for (std::size_t axis = 0; axis < 3; ++axis) s[axis] -= by[axis];
    const auto found = ids_.find({p_.home[v], s});
    return found == ids_.end() ? kNoVertex : found->second;
  }

 private:
  std::array<int, 3> shift(VertexId v) const { return {p_.shift[v][0], p_.shift[v][1], p_.shift[v][2]}; }

  const Periodicity& p_;
  std::map<std::pair<VertexId, std::array<int, 3>>, VertexId> ids_;
};

}  // namespace

std::vector<PeriodicFaces> periodic_faces(const TetMesh& mesh) {
  if (!mesh.periodicity || mesh.triangle_labels.size() != mesh.triangles.size()) return {};
  const Copies copies(*mesh.periodicity);
  const Vec3 size = mesh.periodicity->cell.size();
  std::map<int, std::map<VertexId, VertexId>> nodes;  // by label
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int label = mesh.triangle_labels[i];
    if (label <= kMiddle || label > kLast) continue;
    for (const VertexId v : mesh.triangles[i])
      if (const VertexId master = copies.moved_back(v, periodic_face_shift(label)); master != kNoVertex)
        nodes[label][v] = master;
  }
  std::vector<PeriodicFaces> faces;
  for (const auto& [label, pairs] : nodes) {
    const auto s = periodic_face_shift(label);
    faces.push_back({label,
                     2 * kMiddle - label,
                     {s[0] * size.x, s[1] * size.y, s[2] * size.z},
                     {pairs.begin(), pairs.end()}});
  }
  return faces;
}

}  // namespace unsliver::io
