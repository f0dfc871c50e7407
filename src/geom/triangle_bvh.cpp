#include "geom/triangle_bvh.hpp"

#include <algorithm>
#include <numeric>

namespace unsliver::geom {
namespace {

int longest_axis(const Box3& box) {
  const Vec3 side = box.size();
  if (side.x >= side.y && side.x >= side.z) return 0;
  return side.y >= side.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes, std::uint32_t leaf_size) : order_(boxes.size()) {
  if (boxes.empty()) return;
  std::vector<Vec3> centers(boxes.size());
  std::transform(boxes.begin(), boxes.end(), centers.begin(), [](const Box3& box) { return box.center(); });
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
  // Nodes are appended as they are found, so this one pass visits them all.
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const auto [unused, first, count] = nodes_[n];
    const auto begin = order_.begin() + first, end = begin + count;
    Box3 box, center_box;
    for (auto item = begin; item != end; ++item) {
      box.extend(boxes[*item]);
      center_box.extend(centers[*item]);
    }
    nodes_[n].box = box;
    if (count <= leaf_size) {
      std::sort(begin, end);
      continue;
    }
    const int axis = longest_axis(center_box);
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [&](std::uint32_t i, std::uint32_t j) {
      return centers[i][axis] != centers[j][axis] ? centers[i][axis] < centers[j][axis] : i < j;
    });
    nodes_[n] = {box, static_cast<std::uint32_t>(nodes_.size()), 0};
    nodes_.push_back({{}, first, half});
    nodes_.push_back({{}, first + half, count - half});
  }
}

}  // namespace unsliver::geom
