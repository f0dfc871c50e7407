#include "refine/periodic_extract.hpp"

#include <algorithm>
#include <cmath>

#include "refine/periodic_assembly.hpp"

namespace unsliver::refine {

namespace {

using delaunay::Torus;

/// The point of each vertex, by vertex of the kernel.
std::vector<VertexId> number_homes(const PeriodicRefinement& r) {
  std::vector<VertexId> numbers(r.mesh().vertex_count() + 1);
  auto next = static_cast<VertexId>(r.inputs().places().size());
  for (VertexId v = 1; v < numbers.size(); ++v) numbers[v] = r.is_input(v) ? r.site(v) : next++;
  return numbers;
}

TetMesh homes_of(const PeriodicRefinement& r, const std::vector<VertexId>& numbers) {
  TetMesh mesh;
  mesh.frame = r.world().frame();
  mesh.points.resize(r.mesh().vertex_count());
  mesh.levels.resize(r.mesh().vertex_count());
  const auto& first_points = r.inputs().sites().first_point;
  for (VertexId v = 1; v < numbers.size(); ++v) {
    mesh.levels[numbers[v]] = static_cast<std::uint8_t>(r.label(v));
    mesh.points[numbers[v]] =
        r.is_input(v) ? r.place().wrapped()[first_points[r.site(v)]] : r.to_caller(r.mesh().point(v));
  }
  if (first_points.empty()) return mesh;
  mesh.point_source.assign(first_points.begin(), first_points.end());
  mesh.point_source.resize(mesh.points.size(), -1);
  return mesh;
}

std::int8_t nearest_period(double from, double to, double period) {
  return std::int8_t(std::lround((from - to) / period));
}

}  // namespace

TetMesh extract_periodic(const PeriodicRefinement& r) {
  const Torus torus = r.place().torus();
  const std::vector<VertexId> numbers = number_homes(r);
  std::vector<PeriodicCorners> tets;
  tets.reserve(r.mesh().tet_count());
  for (TetId t = 0; t < r.mesh().slot_count(); ++t) {
    if (!r.mesh().alive(t)) continue;
    PeriodicCorners& corners = tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId corner = r.mesh().tet(t).v[i];  // in the kernel the cell begins elsewhere
      corners[i] = {numbers[Torus::vertex_of(corner)],
                    torus.shift_from_home(r.place().in_frame(r.mesh().point(corner)))};
    }
  }
  return assemble_periodic(homes_of(r, numbers), r.place().cell(), std::move(tets));
}

TetMesh unfold_periodic(TetMesh homes, const Box3& cell, Level coarsest) {
  for (std::uint8_t& level : homes.levels) level = std::min(level, static_cast<std::uint8_t>(coarsest));
  const Vec3 size = cell.size();
  std::vector<PeriodicCorners> tets;
  tets.reserve(homes.tets.size());
  for (const auto& v : homes.tets) {
    PeriodicCorners& corners = tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 &p = homes.points[v[0]], &q = homes.points[v[i]];
      corners[i] = {v[i],
                    {nearest_period(p.x, q.x, size.x), nearest_period(p.y, q.y, size.y),
                     nearest_period(p.z, q.z, size.z)}};
    }
  }
  homes.tets.clear();
  return assemble_periodic(std::move(homes), cell, std::move(tets));
}

}  // namespace unsliver::refine
