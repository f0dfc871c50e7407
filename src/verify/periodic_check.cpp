#include "verify/periodic_check.hpp"

#include <algorithm>
#include <tuple>

#include "verify/delaunay_global.hpp"
#include "verify/grid.hpp"
#include "verify/judge.hpp"
#include "verify/kd_tree.hpp"
#include "verify/structure.hpp"

namespace unsliver::verifier {
namespace {

using Shift = std::array<std::int64_t, 3>;
using Wide = mp::int256_t;

Shift shift_of(const TetMesh& mesh, VertexId v) {
  const auto& s = mesh.periodicity->shift[v];
  return {s[0], s[1], s[2]};
}
Shift operator-(const Shift& a, const Shift& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
bool is_zero(const Shift& s) { return s == Shift{}; }

/// The sides of the cell in units of the frame; 0 where they are no whole number of them.
Row<std::int64_t> period_of(const TetMesh& mesh) {
  const auto& [unit, origin] = *mesh.frame;
  const Box3& cell = mesh.periodicity->cell;
  Row<std::int64_t> period{};
  for (int axis = 0; axis < 3; ++axis) {
    const GridAxis grid(unit, origin[axis]);
    if (!std::isfinite(cell.lo[axis]) || !std::isfinite(cell.hi[axis])) continue;
    const GridPlace lo = grid.place(cell.lo[axis]), hi = grid.place(cell.hi[axis]);
    if (lo.in_range && hi.in_range && lo.exact && hi.exact)
      period[axis] = std::max<std::int64_t>(0, hi.q - lo.q);
  }
  return period;
}

class Alignment {
 public:
  Alignment(const Context& c, FramePlaces& places)
      : c_(c), mesh_(c.mesh), q_(places.q), period_(period_of(c.mesh)) {}

  bool run() {
    const std::size_t n = mesh_.points.size();
    if (mesh_.periodicity->home.size() != n || mesh_.periodicity->shift.size() != n) {
      find({}, "the arrays of homes and shifts need one entry a point");
    } else if (std::any_of(period_.begin(), period_.end(), [](std::int64_t side) { return side == 0; })) {
      find({}, "the periodic cell is no whole number of units of the frame");
    } else {
      for (VertexId v = 0; v < n; ++v) check(v);
    }
    return c_.reporter.count("periodic") == 0;
  }

 private:
  void check(VertexId v) {
    const VertexId home = mesh_.periodicity->home[v];
    const Shift shift = shift_of(mesh_, v);
    if (home >= mesh_.points.size() || mesh_.periodicity->home[home] != home || is_zero(shift) != (home == v))
      return find({v}, "vertex " + std::to_string(v) + " has no home, or is at home and moved");
    const bool is_input = !mesh_.levels.empty() && mesh_.levels[v] == 0;
    if (!mesh_.levels.empty() && mesh_.levels[v] != mesh_.levels[home])
      find({v}, "vertex " + std::to_string(v) + " has another level than its home");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t due = q_[home][axis] + shift[axis] * period_[axis];
      if (std::abs(q_[v][axis] - due) > (is_input ? 1 : 0))
        return find({v}, "vertex " + std::to_string(v) + " at " + full(mesh_.points[v]) +
                             " is not where its home " + std::to_string(home) + " and its shift say");
      q_[v][axis] = due;
    }
  }

  void find(std::vector<std::int64_t> ids, const std::string& text) {
    c_.reporter.find("periodic", std::move(ids), [&] { return text; });
  }

  const Context& c_;
  const TetMesh& mesh_;
  std::vector<Row<std::int64_t>>& q_;
  Row<std::int64_t> period_;
};

/// The corners of the facet opposite to corner i, seen counter-clockwise from outside.
constexpr int kOutward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// A facet as the torus knows it: homes in ascending order, shifts relative to the first one's.
struct TorusFacet {
  std::array<VertexId, 3> home;
  std::array<Shift, 2> relative;
  std::uint64_t facet;  ///< 4 tetrahedron + corner
  Shift base;           ///< the first one's shift
  bool is_even;         ///< ascending order is the outward one

  bool operator<(const TorusFacet& other) const {
    return std::tie(home, relative, facet) < std::tie(other.home, other.relative, other.facet);
  }
  bool is_copy_of(const TorusFacet& other) const { return home == other.home && relative == other.relative; }
};

struct TorusEdge {
  std::array<VertexId, 2> home;
  Shift relative;
  auto operator<=>(const TorusEdge&) const = default;
};

class TorusCheck {
 public:
  TorusCheck(const Context& c, std::vector<Row<std::int64_t>> q)
      : c_(c), mesh_(c.mesh), period_(period_of(c.mesh)), q_(std::move(q)) {}

  void run() {
    gather();
    match();
    count();
    add_up();
    if (c_.options.delaunay_global) look_around();
    judge();
  }

 private:
  /// Vertex `e`, one of the mesh or of the places added to q, must not be inside t's circumsphere.
  struct Question {
    std::size_t t;
    VertexId e;
  };

  void gather() {
    facets_.reserve(4 * mesh_.tets.size());
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      for (std::size_t i = 0; i < 4; ++i) add_facet(t, i);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) add_edge(t, mesh_.tets[t][i], mesh_.tets[t][j]);
    }
    std::sort(facets_.begin(), facets_.end());
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  VertexId home(VertexId v) const { return mesh_.periodicity->home[v]; }

  void add_facet(std::size_t t, std::size_t i) {
    std::array<VertexId, 3> v;
    for (std::size_t j = 0; j < 3; ++j) v[j] = mesh_.tets[t][std::size_t(kOutward[i][j])];
    bool is_even = true;
    for (const auto& [a, b] : {std::pair{0u, 1u}, std::pair{1u, 2u}, std::pair{0u, 1u}})
      if (home(v[b]) < home(v[a])) std::swap(v[a], v[b]), is_even = !is_even;
    const Shift base = shift_of(mesh_, v[0]);
    facets_.push_back({{home(v[0]), home(v[1]), home(v[2])},
                       {shift_of(mesh_, v[1]) - base, shift_of(mesh_, v[2]) - base},
                       4 * t + i,
                       base,
                       is_even});
  }

  void add_edge(std::size_t t, VertexId v, VertexId w) {
    if (home(w) < home(v)) std::swap(v, w);
    if (home(v) == home(w)) find({std::int64_t(t)}, describe_tet(mesh_, t) + " meets its own copy");
    edges_.push_back({{home(v), home(w)}, shift_of(mesh_, w) - shift_of(mesh_, v)});
  }

  void match() {
    for (std::size_t i = 0; i < facets_.size();) {
      std::size_t end = i + 1;
      while (end < facets_.size() && facets_[end].is_copy_of(facets_[i])) ++end;
      const std::size_t t = facets_[i].facet / 4;
      if (end - i == 2 && facets_[i].is_even != facets_[i + 1].is_even)
        ask_across(facets_[i], facets_[i + 1]);
      else
        find({std::int64_t(t)}, "a facet of " + describe_tet(mesh_, t) +
                                    " is not in exactly two tetrahedra of the torus, one on each side");
      i = end;
    }
  }

  void ask_across(const TorusFacet& mine, const TorusFacet& theirs) {
    const Shift moved = mine.base - theirs.base;
    if (is_zero(moved)) return;  // both are in the mesh, side by side
    const VertexId apex = mesh_.tets[theirs.facet / 4][theirs.facet % 4];
    questions_.push_back({mine.facet / 4, add_place(apex, moved)});
    ++across_;
  }

  VertexId add_place(VertexId v, const Shift& moved) {
    Row<std::int64_t> place = q_[v];
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] += moved[axis] * period_[axis];
    q_.push_back(place);
    return VertexId(q_.size() - 1);
  }

  void count() {
    std::vector<bool> seen(mesh_.points.size(), false);
    for (const auto& tet : mesh_.tets)
      for (const VertexId v : tet) seen[home(v)] = true;
    const auto vertices = std::count(seen.begin(), seen.end(), true);
    for (std::size_t i = 1; i < edges_.size(); ++i)
      if (edges_[i].home == edges_[i - 1].home)
        find({edges_[i].home[0], edges_[i].home[1]},
             "two edges lead from vertex " + std::to_string(edges_[i].home[0]) + " to copies of vertex " +
                 std::to_string(edges_[i].home[1]));
    const auto euler = std::int64_t(vertices) - std::int64_t(edges_.size()) +
                       std::int64_t(facets_.size() / 2) - std::int64_t(mesh_.tets.size());
    if (euler != 0) find({}, "the Euler characteristic is " + std::to_string(euler) + ", a torus has 0");
    const std::uint64_t wrong = c_.reporter.count("periodic");
    c_.reporter.line("torus: " + grouped(std::uint64_t(vertices)) + " vertices, " + grouped(edges_.size()) +
                     " edges, " + grouped(facets_.size() / 2) + " facets, " + grouped(across_) +
                     " of them between copies; Euler characteristic " + std::to_string(euler) +
                     (wrong == 0 ? "" : "; " + grouped(wrong) + " defects"));
  }

  /// Six times the volume of a tetrahedron, in units.
  Wide six_volumes(const std::array<VertexId, 4>& v) const {
    std::array<Row<std::int64_t>, 3> d;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) d[i][axis] = q_[v[i + 1]][axis] - q_[v[0]][axis];
    Wide sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
      const Int128 minor = Int128(d[1][y]) * d[2][z] - Int128(d[1][z]) * d[2][y];
      sum += Wide(d[0][axis]) * Wide(minor);
    }
    return sum;
  }

  void add_up() {
    Wide sum = 0;
    for (const auto& v : mesh_.tets) sum += six_volumes(v);
    const bool full = sum == Wide(6) * period_[0] * period_[1] * period_[2];
    if (!full) find({}, "the volumes of the tetrahedra do not add up to the cell's");
    c_.reporter.line(std::string("torus: the volumes ") + (full ? "add" : "do NOT add") +
                     " up to the cell's (exact)");
  }

  void look_around() {
    const CopiesAround around = copies_around(mesh_, used_vertices(mesh_));
    const KdTree tree(around.points, around.ids);
    std::vector<VertexId> place(around.points.size(), kNoVertex);
    for (const VertexId id : around.ids) {
      const auto& s = around.shift[id];
      place[id] = add_place(around.home[id], {s[0], s[1], s[2]});
    }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      c_.pulse.beats(1);
      tree.visit_box(search_box(mesh_.corners(t)), [&](VertexId id, const Vec3&) {
        const auto is_corner = [&](VertexId v) { return q_[v] == q_[place[id]]; };
        const auto& v = mesh_.tets[t];
        if (std::none_of(v.begin(), v.end(), is_corner)) questions_.push_back({t, place[id]});
      });
    }
    c_.reporter.line("Delaunay, globally: every circumsphere against the copies of all vertices around it");
  }

  void judge() {
    const Sites sites(std::move(q_), mesh_.frame->unit);
    Judge judge(sites, {});
    for (const auto& [t, e] : questions_) {
      const Candidate candidate = judge.candidate(mesh_.tets[t]);
      if (candidate.orientation == 0 || judge.in_sphere(candidate, e) <= 0) continue;
      c_.reporter.find("delaunay", {std::int64_t(t)}, [t = t, this] {
        return "the copy of a vertex is strictly inside the circumsphere of " + describe_tet(mesh_, t);
      });
    }
    c_.reporter.report().exact_decisions += judge.exact_decisions();
    c_.reporter.report().filtered_decisions += judge.filtered_decisions();
  }

  void find(std::vector<std::int64_t> ids, const std::string& text) {
    c_.reporter.find("periodic", std::move(ids), [&] { return text; });
  }

  const Context& c_;
  const TetMesh& mesh_;
  const Row<std::int64_t> period_;
  std::vector<Row<std::int64_t>> q_;  ///< of the mesh's vertices, then of copies that are asked for
  std::vector<TorusFacet> facets_;
  std::vector<TorusEdge> edges_;
  std::vector<Question> questions_;
  std::uint64_t across_ = 0;
};

}  // namespace

bool align_copies(const Context& c, FramePlaces& places) { return Alignment(c, places).run(); }

void check_torus(const Context& c, std::vector<Row<std::int64_t>> q) { TorusCheck(c, std::move(q)).run(); }

CopiesAround copies_around(const TetMesh& mesh, const std::vector<VertexId>& used) {
  const Periodicity& periodicity = *mesh.periodicity;
  const Vec3 size = periodicity.cell.size();
  const double reach = 0.25 * std::min({size.x, size.y, size.z});
  const Vec3 margin{reach, reach, reach};
  const Box3 around{periodicity.cell.lo - margin, periodicity.cell.hi + margin};
  CopiesAround copies{mesh.points, {}, {}, periodicity.home, periodicity.shift};
  for (const VertexId v : used) copies.homes.push_back(periodicity.home[v]);
  std::sort(copies.homes.begin(), copies.homes.end());
  copies.homes.erase(std::unique(copies.homes.begin(), copies.homes.end()), copies.homes.end());
  copies.ids = copies.homes;
  for (const VertexId v : copies.homes)
    for (std::int8_t i = -1; i <= 1; ++i)
      for (std::int8_t j = -1; j <= 1; ++j)
        for (std::int8_t k = -1; k <= 1; ++k) {
          const Vec3 p = mesh.points[v] + Vec3{i * size.x, j * size.y, k * size.z};
          if ((i == 0 && j == 0 && k == 0) || !around.contains(p)) continue;
          copies.ids.push_back(VertexId(copies.points.size()));
          copies.points.push_back(p);
          copies.home.push_back(v);
          copies.shift.push_back({i, j, k});
        }
  return copies;
}

}  // namespace unsliver::verifier
