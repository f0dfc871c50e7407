/// \file
/// Where a mesh goes piece by piece, so that it need not fit into memory.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "unsliver/mesh.hpp"

namespace unsliver {

/// What is known before the first piece.
struct MeshHead {
  std::uint64_t vertices = 0, tets = 0;
  Frame frame;
};

/// Receives each vertex and each tetrahedron once. An exception ends the run and reaches its caller.
class MeshSink {
 public:
  virtual ~MeshSink() = default;

  /// First, from the caller's thread.
  virtual void begin(const MeshHead& head) = 0;
  /// Vertices first, first + 1, ... and their lattice levels, as many. From all threads, in no fixed order.
  virtual void points(std::uint64_t first, std::span<const Vec3> points,
                      std::span<const std::uint8_t> levels) = 0;
  /// Tetrahedra first, first + 1, ..., positively oriented. From all threads, in no fixed order; all points
  /// have come before.
  virtual void tets(std::uint64_t first, std::span<const std::array<VertexId, 4>> tets) = 0;
};

}  // namespace unsliver
