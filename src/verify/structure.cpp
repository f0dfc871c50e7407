#include "verify/structure.hpp"

#include <algorithm>

#include "verify/same_place.hpp"

namespace unsliver::verifier {
namespace {

std::string count_of(std::size_t n, const char* what) { return grouped(n) + " " + what; }

void check_length(const Context& c, std::size_t length, std::size_t expected, const std::string& name) {
  if (length == 0 || length == expected) return;
  c.reporter.find("index", {}, [&] {
    return "array `" + name + "` has " + std::to_string(length) + " entries, expected none or " +
           std::to_string(expected);
  });
}

void check_arrays(const Context& c) {
  const TetMesh& m = c.mesh;
  check_length(c, m.regions.size(), m.tets.size(), "regions");
  check_length(c, m.levels.size(), m.points.size(), "levels");
  check_length(c, m.point_source.size(), m.points.size(), "point_source");
  check_length(c, m.triangle_labels.size(), m.triangles.size(), "triangle_labels");
  if (m.points.size() >= kNoVertex || m.tets.size() > kNoVertex) {
    c.reporter.find("index", {},
                    [] { return std::string("the mesh has 2^32 points or tetrahedra or more"); });
  }
}

/// Indices of one simplex: in range, all different.
template <std::size_t N>
void check_simplex(const Context& c, const std::array<VertexId, N>& v, std::size_t id, const char* kind) {
  const auto name = [&] { return std::string(kind) + " " + std::to_string(id); };
  for (std::size_t i = 0; i < N; ++i) {
    if (v[i] >= c.mesh.points.size()) {
      c.reporter.find("index", {static_cast<std::int64_t>(id)}, [&] {
        return name() + " refers to vertex " + std::to_string(v[i]) + ", there are " +
               std::to_string(c.mesh.points.size());
      });
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (v[i] != v[j]) continue;
      c.reporter.find("index", {static_cast<std::int64_t>(id)},
                      [&] { return name() + " uses vertex " + std::to_string(v[i]) + " twice"; });
    }
  }
}

void check_coordinates(const Context& c) {
  for (std::size_t v = 0; v < c.mesh.points.size(); ++v) {
    if (is_finite(c.mesh.points[v])) continue;
    c.reporter.find("coordinates", {static_cast<std::int64_t>(v)}, [&] {
      return "vertex " + std::to_string(v) + " at " + full(c.mesh.points[v]) + " is not finite";
    });
  }
}

}  // namespace

void check_frame(const Frame& f, Reporter& reporter) {
  if (std::isfinite(f.unit) && f.unit > 0 && is_finite(f.origin)) return;
  reporter.find("coordinates", {}, [&] {
    return "the frame has unit " + full(f.unit) + " and origin " + full(f.origin) +
           ": expected a positive unit and finite numbers";
  });
}

bool check_structure(const Context& c) {
  check_arrays(c);
  for (std::size_t t = 0; t < c.mesh.tets.size(); ++t) check_simplex(c, c.mesh.tets[t], t, "tetrahedron");
  for (std::size_t t = 0; t < c.mesh.triangles.size(); ++t) {
    check_simplex(c, c.mesh.triangles[t], t, "triangle");
  }
  check_coordinates(c);
  if (c.mesh.frame) check_frame(*c.mesh.frame, c.reporter);
  const std::string size =
      count_of(c.mesh.points.size(), "points, ") + count_of(c.mesh.tets.size(), "tetrahedra");
  if (c.reporter.report().ok) {
    c.reporter.line("structure: " + size + ", all indices in range, all coordinates finite");
    return true;
  }
  c.reporter.line("structure: " + size + ", " + count_of(c.reporter.report().finding_count, "defects") +
                  ": nothing else was checked");
  return false;
}

std::vector<VertexId> used_vertices(const TetMesh& mesh) {
  std::vector<bool> seen(mesh.points.size(), false);
  for (const auto& tet : mesh.tets) {
    for (const VertexId v : tet) seen[v] = true;
  }
  std::vector<VertexId> used;
  for (std::size_t v = 0; v < seen.size(); ++v) {
    if (seen[v]) used.push_back(static_cast<VertexId>(v));
  }
  return used;
}

void check_coincident(const Context& c, const std::vector<VertexId>& used) {
  std::vector<std::pair<std::uint64_t, VertexId>> order;
  order.reserve(used.size());
  for (const VertexId v : used) order.push_back({hash_of(c.mesh.points[v]), v});
  std::sort(order.begin(), order.end());
  for (std::size_t i = 1; i < order.size(); ++i) {
    const VertexId a = order[i - 1].second, b = order[i].second;
    if (order[i - 1].first != order[i].first || c.mesh.points[a] != c.mesh.points[b]) continue;
    find_coincident(c.reporter, a, b, c.mesh.points[a]);
  }
}

}  // namespace unsliver::verifier
