#include "verify/kd_tree.hpp"

namespace unsliver::verifier {

KdTree::KdTree(const std::vector<Vec3>& points, std::vector<VertexId> ids) {
  items_.reserve(ids.size());
  for (const VertexId id : ids) items_.push_back({points[id], id});
  build(0, items_.size());
}

void KdTree::build(std::size_t from, std::size_t to) {
  if (to - from <= kLeafSize) return;
  Box3 box;
  for (std::size_t i = from; i < to; ++i) box.extend(items_[i].point);
  const Vec3 size = box.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = from + (to - from) / 2;
  const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(from), at(middle), at(to), [axis](const Item& a, const Item& b) {
    return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis] : a.id < b.id;
  });
  items_[middle].axis = axis;
  build(from, middle);
  build(middle + 1, to);
}

KdTree::Nearest KdTree::nearest(const Vec3& p, VertexId except) const {
  Nearest best;
  search(0, items_.size(), p, except, best);
  return best;
}

void KdTree::search(std::size_t from, std::size_t to, const Vec3& p, VertexId except, Nearest& best) const {
  const auto try_item = [&](const Item& item) {
    const double d = dist_sq(item.point, p);
    if (d < best.dist_sq && item.id != except) best = {item.id, d};
  };
  if (to - from <= kLeafSize) {
    for (std::size_t i = from; i < to; ++i) try_item(items_[i]);
    return;
  }
  const std::size_t middle = from + (to - from) / 2;
  const Item& item = items_[middle];
  const double beyond = p[item.axis] - item.point[item.axis];
  try_item(item);
  if (beyond < 0) {
    search(from, middle, p, except, best);
    if (beyond * beyond < best.dist_sq) search(middle + 1, to, p, except, best);
  } else {
    search(middle + 1, to, p, except, best);
    if (beyond * beyond < best.dist_sq) search(from, middle, p, except, best);
  }
}

}  // namespace unsliver::verifier
