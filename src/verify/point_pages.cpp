#include "verify/point_pages.hpp"

namespace unsliver::verifier {

std::array<GridAxis, 3> grid_axes(const unsliver::Frame& frame) {
  return {GridAxis(frame.unit, frame.origin.x), GridAxis(frame.unit, frame.origin.y),
          GridAxis(frame.unit, frame.origin.z)};
}

PointPages::PointPages(const StreamContext& context)
    : context_(context),
      axes_(grid_axes(context.head.frame)),
      frame_of_(static_cast<std::size_t>((context.head.vertices + kPageSize - 1) / kPageSize), kAbsent) {}

void PointPages::load(std::size_t page) {
  const std::uint32_t slot = free_frame();
  const std::uint64_t first = std::uint64_t{page} * kPageSize;
  const auto count =
      static_cast<std::size_t>(std::min<std::uint64_t>(kPageSize, context_.head.vertices - first));
  points_.resize(count);
  levels_.resize(count);
  context_.source.read_points(first, points_, levels_);
  Frame& frame = frames_[slot];
  frame.page = page;
  frame.places.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) frame.places[i][axis] = axes_[axis].place(points_[i][axis]).q;
  frame_of_[page] = slot;
}

/// The clock algorithm: the first frame that was not used since the hand last came by.
std::uint32_t PointPages::free_frame() {
  if (frames_.size() < kMostFrames) {
    frames_.emplace_back();
    return static_cast<std::uint32_t>(frames_.size() - 1);
  }
  while (frames_[hand_].recent) {
    frames_[hand_].recent = false;
    hand_ = (hand_ + 1) % frames_.size();
  }
  frame_of_[frames_[hand_].page] = kAbsent;
  return static_cast<std::uint32_t>(hand_);
}

}  // namespace unsliver::verifier
