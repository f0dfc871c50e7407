/// \file
/// Plain results and inputs: a tetrahedral mesh and a triangle mesh as flat arrays.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver {

/// The integer world of a mesh: point = origin + unit * q with q an integer vector.
/// unit = m * 2^e with 64 <= m < 128 and origin is a multiple of unit, so lattice points are exact doubles.
struct Frame {
  double unit = 1;
  Vec3 origin;
};

/// Bounds on the shape of every tetrahedron. By default they bound nothing.
struct QualityLimits {
  double min_dihedral_deg = 0, max_dihedral_deg = 180;
  double max_radius_edge = std::numeric_limits<double>::infinity();

  friend bool operator==(const QualityLimits&, const QualityLimits&) = default;
};

/// How a mesh of a periodic cell closes upon itself. Each vertex of the torus has one point in the cell, its
/// *home*; the mesh holds copies of it, whole periods away, where tetrahedra reach beyond the cell.
struct Periodicity {
  Box3 cell;                                      ///< half open: its upper faces belong to its copies
  std::vector<VertexId> home;                     ///< n: the point whose copy this is, or the point itself
  std::vector<std::array<std::int8_t, 3>> shift;  ///< n: how many periods from home, along each axis
};

/// The label of triangles beyond which lies a copy of the mesh moved by (i, j, k) periods, each in -1 .. 1
/// and not all of them 0: 1 to 27. The triangle's partner is labelled 28 less that.
constexpr int periodic_face_label(int i, int j, int k) { return 14 + i + 3 * j + 9 * k; }
/// (i, j, k) of a label.
constexpr std::array<int, 3> periodic_face_shift(int label) {
  return {(label - 1) % 3 - 1, (label - 1) / 3 % 3 - 1, (label - 1) / 9 - 1};
}

/// A tetrahedral mesh. n points, m tetrahedra. Optional arrays are empty or have the stated length.
struct TetMesh {
  std::vector<Vec3> points;                        ///< n, the caller's coordinates and units
  std::vector<std::array<VertexId, 4>> tets;       ///< m, positively oriented in meshes of ours
  std::vector<std::int32_t> regions;               ///< m or empty: region label of each tetrahedron
  std::vector<std::uint8_t> levels;                ///< n or empty: lattice level, 0 = an input vertex
  std::vector<std::int64_t> point_source;          ///< n or empty: index in the caller's points, -1 = ours
  std::vector<std::array<VertexId, 3>> triangles;  ///< boundary and interface triangles, may be empty
  std::vector<std::int32_t> triangle_labels;       ///< one per triangle or empty
  std::optional<Frame> frame;                      ///< set in meshes of ours
  std::optional<QualityLimits> limits = std::nullopt;  ///< guaranteed by its maker, where the file says so
  /// Set in periodic meshes, whose tetrahedra are a fundamental set: one of each with all its copies.
  std::optional<Periodicity> periodicity = std::nullopt;

  Tet corners(std::size_t t) const {
    const auto& v = tets[t];
    return {points[v[0]], points[v[1]], points[v[2]], points[v[3]]};
  }
};

/// The facets of exactly one tetrahedron, outward by the right hand where it has a volume, in order of their
/// sorted vertices. Any mesh with valid indices will do, inverted tetrahedra included. O(n log n).
std::vector<std::array<VertexId, 3>> boundary_facets(const TetMesh& mesh);

/// A triangle surface or soup. Indices are valid; nothing else is promised (it may be open, crossed, ...).
struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<std::array<VertexId, 3>> triangles;
  std::string name;  ///< where it came from, for messages
};

/// Field values at the points of a mesh: a background sizing mesh.
struct NodalField {
  TetMesh mesh;
  std::vector<double> values;  ///< one per point
};

}  // namespace unsliver
