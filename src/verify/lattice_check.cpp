#include "verify/lattice_check.hpp"

#include <algorithm>

namespace unsliver::verifier {
namespace {

/// q / 2^k when it is an integer that fits; lattices coarser than the grid hold only 0.
bool multiple_of_power(std::int64_t q, int k) {
  if (k >= 62) return q == 0;
  return (q & ((std::int64_t{1} << k) - 1)) == 0;
}

bool all_multiples(const Row<std::int64_t>& q, int k) {
  return multiple_of_power(q[0], k) && multiple_of_power(q[1], k) && multiple_of_power(q[2], k);
}

std::string lattice_name(int level) { return (level % 2 == 0 ? "BCC_" : "SC_") + std::to_string(level / 2); }

std::string vertex_text(const TetMesh& mesh, VertexId v) {
  return "vertex " + std::to_string(v) + " at " + full(mesh.points[v]) + ", level " +
         std::to_string(mesh.levels[v]) + " = " + lattice_name(mesh.levels[v]) + ", ";
}

void check_on_grid(const Context& c, const FramePlaces& places) {
  for (const VertexId v : places.off_grid) {
    if (c.mesh.levels[v] == 0) continue;
    c.reporter.find("lattice", {v}, [&] {
      return vertex_text(c.mesh, v) + "is not an integer point of the frame (unit " +
             full(c.mesh.frame->unit) + ", origin " + full(c.mesh.frame->origin) + ")";
    });
  }
}

}  // namespace

bool in_lattice(int level, const Row<std::int64_t>& q) {
  const int k = level / 2;
  if (all_multiples(q, k)) return true;
  if (level % 2 != 0 || !all_multiples(q, k - 1)) return false;
  return std::none_of(q.begin(), q.end(), [&](std::int64_t x) { return multiple_of_power(x, k); });
}

void check_lattice(const Context& c, const FramePlaces& places) {
  check_on_grid(c, places);
  std::size_t lattice_vertices = 0;
  for (std::size_t i = 0; i < c.mesh.points.size(); ++i) {
    if (c.mesh.levels[i] == 0) continue;
    ++lattice_vertices;
    const auto v = static_cast<VertexId>(i);
    const auto& q = places.q[v];
    if (in_lattice(c.mesh.levels[v], q)) continue;
    c.reporter.find("lattice", {v}, [&] {
      return vertex_text(c.mesh, v) + "is nearest to grid point (" + std::to_string(q[0]) + ", " +
             std::to_string(q[1]) + ", " + std::to_string(q[2]) + "), which is not in that lattice";
    });
  }
  const std::uint64_t wrong = c.reporter.count("lattice");
  c.reporter.line("lattice: " + grouped(lattice_vertices) + " lattice vertices, " +
                  grouped(c.mesh.points.size() - lattice_vertices) + " input vertices; " +
                  (wrong == 0 ? "every lattice vertex is in the lattice of its level (exact)"
                              : grouped(wrong) + " defects"));
}

bool judged_on_frame(const TetMesh& mesh, const FramePlaces& places) {
  if (!places.in_range) return false;
  return std::all_of(places.off_grid.begin(), places.off_grid.end(),
                     [&](VertexId v) { return !mesh.levels.empty() && mesh.levels[v] == 0; });
}

}  // namespace unsliver::verifier
