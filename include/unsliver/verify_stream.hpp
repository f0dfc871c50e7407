/// \file
/// The independent judge for meshes larger than memory, of the octree strategy.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "unsliver/mesh_sink.hpp"
#include "unsliver/verify.hpp"

namespace unsliver {

/// A mesh that is read a part at a time, parts again and again. What it throws reaches the judge's caller.
class MeshSource {
 public:
  virtual ~MeshSource() = default;

  virtual MeshHead head() const = 0;
  /// Vertices first, first + 1, ... and their levels; both spans are of one length.
  virtual void read_points(std::uint64_t first, std::span<Vec3> points, std::span<std::uint8_t> levels) = 0;
  virtual void read_tets(std::uint64_t first, std::span<std::array<VertexId, 4>> tets) = 0;
};

struct StreamVerifyOptions {
  std::optional<QualityGuarantee> guarantee;
  /// Is a point (the caller's coordinates) in the domain? Empty = cover is not checked.
  std::function<bool(const Vec3&)> inside;
  std::size_t max_findings = 20;
};

/// Tetrahedra that differ by a translation only.
struct TetShape {
  std::uint64_t first_tet = 0, tets = 0;  ///< the first of them, and how many there are
  Tet corners;                            ///< in the caller's units, the first corner at the origin
};

struct StreamVerifyReport : VerifyReport {
  Box3 bounds;
  std::vector<TetShape> shapes;  ///< by their first tetrahedra; empty where not all could be read
};

/// Decides exactly, in bounded memory (150 MB, for hostile files 400 MB): are all vertices where their levels
/// say, no two at one place; all tetrahedra positive; the guarantee kept by all; each facet in one
/// tetrahedron or on the two sides of two; the sum of the volumes what the facets in one enclose? And by
/// samples, four a facet: is the domain nowhere just beyond a facet in one, where the mesh would have a hole?
/// Tetrahedra that are equal but for their places are judged once: lattice meshes have some thousand shapes.
/// Meshes with 2^20 or more are refused with a finding, and are for verify(). Never throws on a bad mesh.
StreamVerifyReport verify_stream(MeshSource& source, const StreamVerifyOptions& options,
                                 const Control& control = {});

}  // namespace unsliver
