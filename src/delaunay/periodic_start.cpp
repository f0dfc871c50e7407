// Why half a period around the cell is wide enough: a ball of less than that in diameter that touches a point
// of the cell lies there, so if it holds none of the copies it is an empty ball of the torus. Where all
// tetrahedra with a corner in the cell have such circumspheres, all these are tetrahedra of the torus; around
// each vertex they close, so there are no others.
#include "delaunay/periodic_start.hpp"

#include <algorithm>

namespace unsliver::delaunay {

namespace {

struct Copy {
  VertexId vertex;  ///< of the torus
  Torus::Shift shift;
};

/// The points' copies in the cell and around it, and their Delaunay tetrahedralization.
class Window {
 public:
  Window(const Torus& torus, std::span<const Vec3> points) {
    const Vec3& period = torus.period();
    const double margin = 0.5 * std::min({period.x, period.y, period.z});
    const auto add_along = [&](const auto& next, int axis, const Vec3& p, VertexId v,
                               const Vec3& at) -> void {
      if (axis == 3) return add(at, {v, torus.shift_from_home(at)});
      for (int step = -1; step <= 1; ++step) {
        Vec3 moved = at;
        moved[axis] = p[axis] + step * period[axis];
        if (-margin <= moved[axis] && moved[axis] < period[axis] + margin) next(next, axis + 1, p, v, moved);
      }
    };
    for (VertexId i = 0; i < points.size(); ++i) add_along(add_along, 0, points[i], i + 1, {});
    const std::vector<VertexId> ids = mesh_.insert_all(places_);
    copy_of_.resize(copies_.size() + 1);
    for (std::size_t i = 0; i < ids.size(); ++i) copy_of_[ids[i]] = copies_[i];
  }

  bool is_fine_enough(const std::function<bool(const Tet&)>& is_small) const {
    for (TetId t = 0; t < mesh_.slot_count(); ++t)
      if (mesh_.alive(t) && has_home_corner(t) && (mesh_.is_ghost(t) || !is_small(mesh_.corners(t))))
        return false;
    return mesh_.tet_count() > 0;
  }

  /// Of all copies of a tetrahedron the one whose first vertex, by number, is at home.
  std::vector<std::array<VertexId, 4>> fold() const {
    std::vector<std::array<VertexId, 4>> tets;
    for (TetId t = 0; t < mesh_.slot_count(); ++t) {
      if (!mesh_.is_finite(t)) continue;
      VertexId v[4];
      std::array<Torus::Shift, 4> shifts;
      std::size_t first = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const Copy& copy = copy_of_[mesh_.tet(t).v[i]];
        v[i] = copy.vertex;
        shifts[i] = copy.shift;
        if (v[i] < v[first]) first = i;
      }
      if (!is_zero(shifts[first])) continue;
      Torus::pack(v, shifts);
      tets.push_back({v[0], v[1], v[2], v[3]});
    }
    return tets;
  }

 private:
  bool has_home_corner(TetId t) const {
    return std::any_of(mesh_.tet(t).v, mesh_.tet(t).v + 4,
                       [this](VertexId v) { return v != kInfinite && is_zero(copy_of_[v].shift); });
  }
  static bool is_zero(const Torus::Shift& s) { return (s.x | s.y | s.z) == 0; }

  void add(const Vec3& at, const Copy& copy) {
    places_.push_back(at);
    copies_.push_back(copy);
  }

  std::vector<Vec3> places_;
  std::vector<Copy> copies_;   ///< of each place
  std::vector<Copy> copy_of_;  ///< by vertex of mesh_
  Triangulation mesh_;
};

}  // namespace

std::optional<PeriodicTriangulation> periodic_start(const Torus& torus, std::span<const Vec3> points,
                                                    const std::function<bool(const Tet&)>& is_small) {
  const Window window(torus, points);
  if (!window.is_fine_enough(is_small)) return std::nullopt;
  PeriodicTriangulation mesh(torus);
  mesh.adopt(points, window.fold());
  return mesh;
}

}  // namespace unsliver::delaunay
