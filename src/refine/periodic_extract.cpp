#include "refine/periodic_extract.hpp"

#include <algorithm>
#include <unordered_map>

#include "unsliver/periodic.hpp"

namespace unsliver::refine {

namespace {

using delaunay::Torus;

class Extraction {
 public:
  explicit Extraction(const PeriodicRefinement& r) : r_(r), torus_(r.place().torus()) {}

  TetMesh run() {
    mesh_.frame = r_.world().frame();
    mesh_.periodicity.emplace().cell = r_.place().cell();
    add_homes();
    place_tets();
    bring_strangers_home();
    for (const Corners& tet : tets_) mesh_.tets.push_back(points_of(tet));
    add_faces();
    return std::move(mesh_);
  }

 private:
  /// The copy of a vertex, told with respect to the caller's cell: in the kernel the cell begins elsewhere.
  struct Corner {
    VertexId v;
    Torus::Shift shift;

    bool is_home() const { return (shift.x | shift.y | shift.z) == 0; }
  };
  using Corners = std::array<Corner, 4>;

  static Torus::Shift difference(Torus::Shift a, Torus::Shift b) {
    return {std::int8_t(a.x - b.x), std::int8_t(a.y - b.y), std::int8_t(a.z - b.z)};
  }

  void add_homes() {
    const std::size_t sites = r_.inputs().places().size(), count = r_.mesh().vertex_count();
    mesh_.points.resize(count);
    mesh_.levels.resize(count);
    mesh_.periodicity->home.resize(count);
    mesh_.periodicity->shift.resize(count, {0, 0, 0});
    index_.resize(count + 1);
    auto next = static_cast<VertexId>(sites);
    for (VertexId v = 1; v <= count; ++v) {
      const VertexId i = index_[v] = r_.is_input(v) ? r_.site(v) : next++;
      mesh_.levels[i] = static_cast<std::uint8_t>(r_.label(v));
      mesh_.periodicity->home[i] = i;
      mesh_.points[i] = r_.is_input(v) ? r_.place().wrapped()[r_.inputs().sites().first_point[i]]
                                       : r_.to_caller(r_.mesh().point(v));
    }
    const auto& first_points = r_.inputs().sites().first_point;
    if (first_points.empty()) return;
    mesh_.point_source.assign(first_points.begin(), first_points.end());
    mesh_.point_source.resize(count, -1);
  }

  /// Each where its least corner along each axis is in the cell.
  void place_tets() {
    number_.resize(r_.mesh().slot_count());
    for (TetId t = 0; t < r_.mesh().slot_count(); ++t) {
      if (!r_.mesh().alive(t)) continue;
      number_[t] = tets_.size();
      tets_.push_back(corners_of(t));
    }
  }

  Corners corners_of(TetId t) const {
    VertexId v[4];
    std::array<Torus::Shift, 4> shifts;
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId corner = v[i] = r_.mesh().tet(t).v[i];
      shifts[i] = torus_.shift_from_home(r_.place().in_frame(r_.mesh().point(corner)));
    }
    Torus::pack(v, shifts);
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = {Torus::vertex_of(v[i]), Torus::shift_of(v[i])};
    return corners;
  }

  /// A vertex may be a corner only as a copy. Nobody wants points without tetrahedra: one of its tetrahedra
  /// is moved, if there is one whose other vertices can do without.
  void bring_strangers_home() {
    std::vector<std::uint32_t> uses(index_.size(), 0);
    for (const Corners& tet : tets_) count_homes(tet, uses, 1);
    for (Corners& tet : tets_)
      for (const Corner& corner : Corners(tet)) {
        if (uses[corner.v] > 0 || !is_dispensable(tet, uses)) continue;
        count_homes(tet, uses, -1);
        for (Corner& c : tet) c.shift = difference(c.shift, corner.shift);
        count_homes(tet, uses, 1);
      }
  }
  static void count_homes(const Corners& tet, std::vector<std::uint32_t>& uses, int sign) {
    for (const Corner& c : tet)
      if (c.is_home()) uses[c.v] += static_cast<std::uint32_t>(sign);
  }
  static bool is_dispensable(const Corners& tet, const std::vector<std::uint32_t>& uses) {
    return std::all_of(tet.begin(), tet.end(),
                       [&](const Corner& c) { return !c.is_home() || uses[c.v] > 1; });
  }

  std::array<VertexId, 4> points_of(const Corners& tet) {
    return {point_of(tet[0]), point_of(tet[1]), point_of(tet[2]), point_of(tet[3])};
  }

  VertexId point_of(const Corner& corner) {
    const VertexId home = index_[corner.v];
    if (corner.is_home()) return home;
    const Torus::Shift& s = corner.shift;
    const std::uint64_t key =
        27 * std::uint64_t(corner.v) + std::uint64_t(periodic_face_label(s.x, s.y, s.z) - 1);
    const auto [at, is_new] = copies_.try_emplace(key, static_cast<VertexId>(mesh_.points.size()));
    if (is_new) add_copy(home, s);
    return at->second;
  }

  void add_copy(VertexId home, const Torus::Shift& shift) {
    const Vec3 size = mesh_.periodicity->cell.size();
    mesh_.points.push_back(mesh_.points[home] + Vec3{shift.x * size.x, shift.y * size.y, shift.z * size.z});
    mesh_.levels.push_back(mesh_.levels[home]);
    if (!mesh_.point_source.empty()) mesh_.point_source.push_back(-1);
    mesh_.periodicity->home.push_back(home);
    mesh_.periodicity->shift.push_back({shift.x, shift.y, shift.z});
  }

  /// Facets behind which the neighbour is not where it is in the mesh.
  void add_faces() {
    for (TetId t = 0; t < r_.mesh().slot_count(); ++t)
      for (int slot = 0; slot < 4 && r_.mesh().alive(t); ++slot) add_face(t, slot);
  }

  void add_face(TetId t, int slot) {
    const Corners& theirs = tets_[number_[delaunay::tet_of(r_.mesh().tet(t).n[slot])]];
    const int* c = delaunay::kFacetCorners[slot];
    const Corner& mine = tets_[number_[t]][std::size_t(c[0])];
    const auto same =
        std::find_if(theirs.begin(), theirs.end(), [&](const Corner& w) { return w.v == mine.v; });
    const Torus::Shift shift = difference(mine.shift, same->shift);
    if ((shift.x | shift.y | shift.z) == 0) return;
    const auto& points = mesh_.tets[number_[t]];
    mesh_.triangles.push_back(
        {points[std::size_t(c[0])], points[std::size_t(c[2])], points[std::size_t(c[1])]});
    mesh_.triangle_labels.push_back(periodic_face_label(shift.x, shift.y, shift.z));
  }

  const PeriodicRefinement& r_;
  const Torus torus_;
  TetMesh mesh_;
  std::vector<Corners> tets_;
  std::vector<std::size_t> number_;                     ///< in tets_, by the kernel's slot
  std::vector<VertexId> index_;                         ///< the point at home, by vertex
  std::unordered_map<std::uint64_t, VertexId> copies_;  ///< the other points
};

}  // namespace

TetMesh extract_periodic(const PeriodicRefinement& refinement) { return Extraction(refinement).run(); }

}  // namespace unsliver::refine
