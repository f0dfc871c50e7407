/// \file
/// What every reader must hold to on any bytes: an Error, or a mesh that can be used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "unsliver/error.hpp"
#include "unsliver/mesh.hpp"
#include "unsliver/points.hpp"

namespace unsliver::fuzz {

inline void require(bool condition) {
  if (!condition) std::abort();
}

template <class Element>
void require_valid(const std::vector<Element>& elements, std::size_t vertex_count) {
  for (const Element& element : elements)
    for (const VertexId v : element) require(v < vertex_count);
}

inline void require_valid(const std::vector<Vec3>& points) {
  for (const Vec3& p : points) require(is_finite(p));
}

inline void require_valid(const TriangleMesh& mesh) {
  require(!mesh.triangles.empty());
  require_valid(mesh.points);
  require_valid(mesh.triangles, mesh.points.size());
}

inline void require_valid(const PointSet& set) {
  require(!set.points.empty());
  require_valid(set.points);
  require(set.sizes.empty() || set.sizes.size() == set.points.size());
  for (const double size : set.sizes) require(size > 0 && size < std::numeric_limits<double>::infinity());
}

inline void require_valid(const TetMesh& mesh) {
  require(!mesh.tets.empty());
  require_valid(mesh.points);
  require_valid(mesh.tets, mesh.points.size());
  require_valid(mesh.triangles, mesh.points.size());
  require(mesh.regions.empty() || mesh.regions.size() == mesh.tets.size());
  require(mesh.triangle_labels.empty() || mesh.triangle_labels.size() == mesh.triangles.size());
  require(mesh.levels.empty() || mesh.levels.size() == mesh.points.size());
  require(mesh.point_source.empty() || mesh.point_source.size() == mesh.points.size());
}

/// Runs a reader on the bytes. Its Error must have a message; any other exception is a fault.
template <class Parse>
void check_reader(std::string_view bytes, const Parse& parse) {
  try {
    require_valid(parse(bytes));
  } catch (const Error& error) {
    require(std::string_view(error.what()).starts_with("fuzz"));
  }
}

}  // namespace unsliver::fuzz
