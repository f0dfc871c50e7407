#include "box_check.hpp"

#include <fmt/format.h>

#include "text.hpp"

namespace unsliver::cli {
namespace {

__extension__ using Wide = __int128;
using Steps = std::array<std::int64_t, 3>;  ///< from the lower corner, in units of the mesh's frame

class BoxCheck {
 public:
  BoxCheck(const TetMesh& mesh, const Box3& box, VerifyReport& report)
      : mesh_(mesh), box_(box), report_(report), extent_(steps_to(box.hi)) {}

  void run() {
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (!box_.contains(mesh_.points[v])) find("vertex", v, "is outside the box");
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) add_triangle(i);
    for (std::size_t face = 0; face < 6; ++face)
      if (twice_area_[face] != twice_area_of(face))
        find("face", face + 1, "is not covered exactly by its triangles");
    report_.checks.push_back(fmt::format("box: {} cover its 6 faces exactly, no vertex is outside{}",
                                         plural(mesh_.triangles.size(), "triangle"),
                                         wrong_ == 0 ? "" : ": VIOLATED"));
  }

 private:
  /// Exact for lattice points of the box.
  Steps steps_to(const Vec3& p) const {
    const Vec3 d = p - box_.lo;
    const double unit = mesh_.frame->unit;
    return {std::int64_t(d.x / unit), std::int64_t(d.y / unit), std::int64_t(d.z / unit)};
  }

  Wide twice_area_of(std::size_t face) const {
    return Wide(2) * extent_[(face / 2 + 1) % 3] * extent_[(face / 2 + 2) % 3];
  }

  void add_triangle(std::size_t i) {
    const auto& t = mesh_.triangles[i];
    const std::int64_t face = std::int64_t(mesh_.triangle_labels[i]) - 1;
    if (face < 0 || face > 5) return find("triangle", i, "has a label that names no face");
    const int axis = int(face / 2);
    const bool high = face % 2 == 1;
    for (const VertexId v : t)
      if (mesh_.points[v][axis] != (high ? box_.hi : box_.lo)[axis])
        return find("triangle", i, "is not on the face that its label names");
    const Wide area = twice_area_along(axis, t);
    if ((high ? area : -area) <= 0) find("triangle", i, "does not face outward");
    twice_area_[std::size_t(face)] += high ? area : -area;
  }

  Wide twice_area_along(int axis, const std::array<VertexId, 3>& t) const {
    const auto u = std::size_t((axis + 1) % 3), v = std::size_t((axis + 2) % 3);
    const Steps a = steps_to(mesh_.points[t[0]]), b = steps_to(mesh_.points[t[1]]),
                c = steps_to(mesh_.points[t[2]]);
    return Wide(b[u] - a[u]) * (c[v] - a[v]) - Wide(b[v] - a[v]) * (c[u] - a[u]);
  }

  void find(const char* what, std::size_t id, const char* fault) {
    constexpr int kShown = 20;
    report_.ok = false;
    ++report_.finding_count;
    if (++wrong_ <= kShown)
      report_.findings.push_back({"box", fmt::format("{} {} {}", what, id, fault), {std::int64_t(id)}});
  }

  const TetMesh& mesh_;
  const Box3& box_;
  VerifyReport& report_;
  Steps extent_;
  std::array<Wide, 6> twice_area_{};
  int wrong_ = 0;
};

}  // namespace

void check_box(const TetMesh& mesh, const Box3& box, VerifyReport& report) {
  BoxCheck(mesh, box, report).run();
}

}  // namespace unsliver::cli
