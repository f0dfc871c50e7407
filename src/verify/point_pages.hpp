/// \file
/// Integer places of the vertices of a mesh that does not fit into memory.
#pragma once

#include <memory>

#include "verify/grid.hpp"
#include "verify/stream_context.hpp"

namespace unsliver::verifier {

/// Keeps the pages used last, about. Neighbours in number should be neighbours in use.
class PointPages {
 public:
  /// Requires: all vertices are in range of the frame's grid.
  explicit PointPages(const StreamContext& context);

  /// The integers nearest to the vertex's place on the grid.
  Row<std::int64_t> operator[](VertexId v) {
    const std::size_t page = v / kPageSize;
    if (frame_of_[page] == kAbsent) load(page);
    Frame& frame = frames_[frame_of_[page]];
    frame.recent = true;
    return frame.places[v % kPageSize];
  }

 private:
  static constexpr std::size_t kPageSize = 4096, kMostFrames = 1024;
  static constexpr std::uint32_t kAbsent = ~std::uint32_t{0};
  struct Frame {
    std::size_t page = 0;
    bool recent = false;  ///< used since the hand last came by
    std::vector<Row<std::int64_t>> places;
  };

  void load(std::size_t page);
  std::uint32_t free_frame();

  const StreamContext& context_;
  std::array<GridAxis, 3> axes_;
  std::vector<std::uint32_t> frame_of_;  ///< by page
  std::vector<Frame> frames_;
  std::size_t hand_ = 0;
  std::vector<Vec3> points_;
  std::vector<std::uint8_t> levels_;
};

std::array<GridAxis, 3> grid_axes(const unsliver::Frame& frame);

}  // namespace unsliver::verifier
