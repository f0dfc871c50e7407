// Why half a period around the cell is wide enough: a ball without copies that lie there and with a corner in
// the cell is an empty ball of the torus, or else the smaller one, of half that period in diameter and
// tangent at that corner from inside, were one. So all tetrahedra with a corner in the cell are right.
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
      if ((shifts[first].x | shifts[first].y | shifts[first].z) != 0) continue;
      Torus::pack(v, shifts);
      tets.push_back({v[0], v[1], v[2], v[3]});
    }
    return tets;
  }

 private:
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

PeriodicTriangulation periodic_start(const Torus& torus, std::span<const Vec3> points) {
  PeriodicTriangulation mesh(torus);
  mesh.adopt(points, Window(torus, points).fold());
  return mesh;
}

}  // namespace unsliver::delaunay
