#include "sizing/cone_field.hpp"

#include "sizing/tree_search.hpp"

namespace unsliver::sizing {
namespace {

double distance(const Box3& a, const Box3& b) {
  Vec3 gap;
  for (int axis = 0; axis < 3; ++axis)
    gap[axis] = std::max({a.lo[axis] - b.hi[axis], b.lo[axis] - a.hi[axis], 0.0});
  return norm(gap);
}

}  // namespace

ConeField::ConeField(std::vector<Box3> boxes, std::vector<double> heights, double slope)
    : boxes_(std::move(boxes)),
      heights_(std::move(heights)),
      slope_(slope),
      tree_(boxes_),
      node_heights_(node_minima(tree_, heights_)) {}

double ConeField::least_over(const Box3& query, double limit) const {
  const auto node = [&](std::uint32_t n) {
    return node_heights_[n] + slope_ * distance(query, tree_.nodes()[n].box);
  };
  const auto item = [&](std::uint32_t i) { return heights_[i] + slope_ * distance(query, boxes_[i]); };
  return least_item(tree_, limit, node, item).value;
}

}  // namespace unsliver::sizing
