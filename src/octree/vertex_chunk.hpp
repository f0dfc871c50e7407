/// \file
/// Vertices on their way to a sink.
#pragma once

#include <vector>

#include "unsliver/mesh_sink.hpp"

namespace unsliver::octree {

/// How many vertices or tetrahedra are handed to a sink at once, about.
inline constexpr std::size_t kChunkSize = std::size_t{1} << 16;

/// One thread's: those in a row go together.
class VertexChunk {
 public:
  explicit VertexChunk(MeshSink& sink) : sink_(&sink) {}

  void add(VertexId number, const Vec3& p, std::uint8_t level) {
    if (number != first_ + points_.size() || points_.size() == kChunkSize) {
      flush();
      first_ = number;
    }
    points_.push_back(p);
    levels_.push_back(level);
  }

  /// To be called after the last one.
  void flush() {
    if (!points_.empty()) sink_->points(first_, points_, levels_);
    points_.clear();
    levels_.clear();
  }

 private:
  MeshSink* sink_;
  std::uint64_t first_ = 0;
  std::vector<Vec3> points_;
  std::vector<std::uint8_t> levels_;
};

}  // namespace unsliver::octree
