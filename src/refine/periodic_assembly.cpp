#include "refine/periodic_assembly.hpp"

#include <algorithm>
#include <compare>
#include <unordered_map>

namespace unsliver::refine {

namespace {

using Shift = delaunay::Torus::Shift;

Shift difference(Shift a, Shift b) {
  return {std::int8_t(a.x - b.x), std::int8_t(a.y - b.y), std::int8_t(a.z - b.z)};
}

void move_back(PeriodicCorners& tet, Shift by) {
  for (PeriodicCorner& c : tet) c.shift = difference(c.shift, by);
}

Shift least_shift(const PeriodicCorners& tet) {
  Shift least = tet[0].shift;
  for (const PeriodicCorner& c : tet)
    least = {std::min(least.x, c.shift.x), std::min(least.y, c.shift.y), std::min(least.z, c.shift.z)};
  return least;
}

/// Where tetrahedra are, so that most vertices are corners at home.
class Placement {
 public:
  Placement(std::vector<PeriodicCorners>& tets, std::size_t vertices) : tets_(tets), uses_(vertices, 0) {}

  void run() {
    for (PeriodicCorners& tet : tets_) {
      move_back(tet, least_shift(tet));
      count_homes(tet, 1);
    }
    for (PeriodicCorners& tet : tets_) bring_home(tet);
  }

 private:
  /// Moves it to where a vertex that is no corner at home is one, if its other vertices can do without.
  void bring_home(PeriodicCorners& tet) {
    for (const PeriodicCorner& corner : PeriodicCorners(tet)) {
      if (uses_[corner.home] > 0 || !is_dispensable(tet)) continue;
      count_homes(tet, -1);
      move_back(tet, corner.shift);
      count_homes(tet, 1);
      return;
    }
  }
  void count_homes(const PeriodicCorners& tet, int sign) {
    for (const PeriodicCorner& c : tet)
      if (c.is_home()) uses_[c.home] += sign;
  }
  bool is_dispensable(const PeriodicCorners& tet) const {
    return std::all_of(tet.begin(), tet.end(),
                       [this](const PeriodicCorner& c) { return !c.is_home() || uses_[c.home] > 1; });
  }

  std::vector<PeriodicCorners>& tets_;
  std::vector<int> uses_;  ///< as corners at home, by vertex
};

class Assembly {
 public:
  Assembly(TetMesh homes, const Box3& cell) : mesh_(std::move(homes)), size_(cell.size()) {
    Periodicity& periodicity = mesh_.periodicity.emplace();
    periodicity.cell = cell;
    periodicity.home.resize(mesh_.points.size());
    for (VertexId v = 0; v < mesh_.points.size(); ++v) periodicity.home[v] = v;
    periodicity.shift.resize(mesh_.points.size(), {0, 0, 0});
  }

  TetMesh run(const std::vector<PeriodicCorners>& tets) {
    mesh_.tets.reserve(tets.size());
    for (const PeriodicCorners& t : tets)
      mesh_.tets.push_back({point(t[0]), point(t[1]), point(t[2]), point(t[3])});
    add_faces();
    return std::move(mesh_);
  }

 private:
  VertexId point(const PeriodicCorner& corner) {
    if (corner.is_home()) return corner.home;
    const Shift& s = corner.shift;
    const std::uint64_t key =
        27 * std::uint64_t(corner.home) + std::uint64_t(periodic_face_label(s.x, s.y, s.z));
    const auto [at, is_new] = copies_.try_emplace(key, static_cast<VertexId>(mesh_.points.size()));
    if (is_new) add_copy(corner);
    return at->second;
  }

  void add_copy(const PeriodicCorner& corner) {
    const Shift& s = corner.shift;
    mesh_.points.push_back(mesh_.points[corner.home] + Vec3{s.x * size_.x, s.y * size_.y, s.z * size_.z});
    mesh_.levels.push_back(mesh_.levels[corner.home]);
    if (!mesh_.point_source.empty()) mesh_.point_source.push_back(-1);
    mesh_.periodicity->home.push_back(corner.home);
    mesh_.periodicity->shift.push_back({s.x, s.y, s.z});
  }

  /// The facets that the mesh ends at are those whose neighbour is elsewhere, and come in pairs.
  void add_faces() {
    mesh_.triangles = boundary_facets(mesh_);
    std::vector<Named> named;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) named.push_back({homes_of(i), i});
    std::sort(named.begin(), named.end());
    mesh_.triangle_labels.resize(mesh_.triangles.size());
    for (std::size_t i = 0; i + 1 < named.size(); i += 2) {
      label(named[i].triangle, named[i + 1].triangle);
      label(named[i + 1].triangle, named[i].triangle);
    }
  }

  struct Named {
    std::array<VertexId, 3> homes;
    std::uint32_t triangle;
    auto operator<=>(const Named&) const = default;
  };
  std::array<VertexId, 3> homes_of(std::uint32_t triangle) const {
    const auto& home = mesh_.periodicity->home;
    const auto& t = mesh_.triangles[triangle];
    std::array<VertexId, 3> homes{home[t[0]], home[t[1]], home[t[2]]};
    std::sort(homes.begin(), homes.end());
    return homes;
  }

  void label(std::uint32_t triangle, std::uint32_t partner) {
    const auto& home = mesh_.periodicity->home;
    const auto& shift = mesh_.periodicity->shift;
    const VertexId v = mesh_.triangles[triangle][0];
    const auto& other = mesh_.triangles[partner];
    const VertexId w =
        *std::find_if(other.begin(), other.end(), [&](VertexId u) { return home[u] == home[v]; });
    mesh_.triangle_labels[triangle] =
        periodic_face_label(shift[v][0] - shift[w][0], shift[v][1] - shift[w][1], shift[v][2] - shift[w][2]);
  }

  TetMesh mesh_;
  Vec3 size_;
  std::unordered_map<std::uint64_t, VertexId> copies_;
};

}  // namespace

TetMesh assemble_periodic(TetMesh homes, const Box3& cell, std::vector<PeriodicCorners> tets) {
  Placement(tets, homes.points.size()).run();
  return Assembly(std::move(homes), cell).run(tets);
}

}  // namespace unsliver::refine
