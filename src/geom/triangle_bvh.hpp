/// \file
/// A binary tree of bounding boxes over any set of boxes. Users walk the nodes themselves.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::geom {

class BoxTree {
 public:
  /// An inner node (count = 0) has its children at nodes first and first + 1, both after it;
  /// a leaf holds order()[first .. first + count).
  struct Node {
    Box3 box;
    std::uint32_t first = 0, count = 0;
    bool is_leaf() const { return count > 0; }
  };

  /// Deterministic: median splits, ties by index. No node when `boxes` is empty. O(n log^2 n).
  explicit BoxTree(std::span<const Box3> boxes, std::uint32_t leaf_size = 4);

  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls on_leaf(first, count) for the leaves reached; enter(node) false prunes, on_leaf true stops the
  /// walk. Returns true if stopped.
  template <class Enter, class OnLeaf>
  bool walk(Enter enter, OnLeaf on_leaf) const;

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

/// Pending nodes of a depth-first walk: median splits of fewer than 2^32 items are at most 32 deep.
class NodeStack {
 public:
  bool empty() const { return size_ == 0; }
  void push(std::uint32_t node) { nodes_[size_++] = node; }
  std::uint32_t pop() { return nodes_[--size_]; }

 private:
  std::array<std::uint32_t, 40> nodes_;
  int size_ = 0;
};

template <class Enter, class OnLeaf>
bool BoxTree::walk(Enter enter, OnLeaf on_leaf) const {
  if (nodes_.empty()) return false;
  NodeStack pending;
  pending.push(0);
  while (!pending.empty()) {
    const Node& node = nodes_[pending.pop()];
    if (!enter(node)) continue;
    if (node.is_leaf()) {
      if (on_leaf(node.first, node.count)) return true;
    } else {
      pending.push(node.first + 1);
      pending.push(node.first);
    }
  }
  return false;
}

/// Squared distance from p to the box, 0 inside.
inline double dist_sq(const Vec3& p, const Box3& box) {
  const double dx = std::max({box.lo.x - p.x, 0.0, p.x - box.hi.x});
  const double dy = std::max({box.lo.y - p.y, 0.0, p.y - box.hi.y});
  const double dz = std::max({box.lo.z - p.z, 0.0, p.z - box.hi.z});
  return dx * dx + dy * dy + dz * dz;
}

}  // namespace unsliver::geom
