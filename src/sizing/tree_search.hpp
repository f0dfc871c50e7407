/// \file
/// The least value over the items of a box tree, by branch and bound.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geom/triangle_bvh.hpp"

namespace unsliver::sizing {

/// For every node, the least of its items' values.
inline std::vector<double> node_minima(const geom::BoxTree& tree, std::span<const double> item_values) {
  const auto& nodes = tree.nodes();
  std::vector<double> least(nodes.size(), std::numeric_limits<double>::infinity());
  for (std::size_t n = nodes.size(); n-- > 0;) {
    const geom::BoxTree::Node& node = nodes[n];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      least[n] = std::min(least[n], item_values[tree.order()[i]]);
    if (!node.is_leaf()) least[n] = std::min(least[node.first], least[node.first + 1]);
  }
  return least;
}

struct Least {
  double value;
  std::uint32_t item = 0xffffffff;  ///< 0xffffffff: no item is below the limit
};

/// The least value(item) below `limit`, or the limit. Requires bound(node index) <= value of each of the
/// node's items. The more promising child is searched first.
template <class NodeBound, class ItemValue>
Least least_item(const geom::BoxTree& tree, double limit, NodeBound bound, ItemValue value) {
  using Pending = std::pair<double, std::uint32_t>;
  std::array<Pending, 40> pending;
  std::size_t size = 0;
  Least best{limit};
  if (!tree.nodes().empty()) pending[size++] = {bound(0), 0};
  while (size > 0) {
    const auto [node_bound, n] = pending[--size];
    if (!(node_bound < best.value)) continue;
    const geom::BoxTree::Node& node = tree.nodes()[n];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t item = tree.order()[i];
      const double v = value(item);
      if (v < best.value) best = {v, item};
    }
    if (node.is_leaf()) continue;
    Pending near{bound(node.first), node.first}, far{bound(node.first + 1), node.first + 1};
    if (far.first < near.first) std::swap(near, far);
    pending[size++] = far;
    pending[size++] = near;
  }
  return best;
}

}  // namespace unsliver::sizing
