#include "octree/forest.hpp"

#include <limits>

#include "unsliver/error.hpp"

namespace unsliver::octree {

Forest::Forest(const Brick& brick) : brick_(brick) {
  const Node leaf{-1, std::uint8_t(brick.exponent), 0, 0};
  nodes_.resize(std::size_t(brick.count[0]) * brick.count[1] * brick.count[2], leaf);
}

NodeId Forest::root(int i, int j, int k) const {
  const auto& n = brick_.count;
  const auto wrapped = [](int at, int count) { return (at % count + count) % count; };
  if (brick_.periodic) i = wrapped(i, n[0]), j = wrapped(j, n[1]), k = wrapped(k, n[2]);
  if (i < 0 || j < 0 || k < 0 || i >= n[0] || j >= n[1] || k >= n[2]) return kNoNode;
  return i + n[0] * (j + n[1] * k);
}

Cell Forest::root_cell(int i, int j, int k) const {
  const int e = brick_.exponent;
  return {root(i, j, k), e, brick_.lo[0] + (std::int64_t(i) << e), brick_.lo[1] + (std::int64_t(j) << e),
          brick_.lo[2] + (std::int64_t(k) << e)};
}

void Forest::require_room(std::size_t more) const {
  if (nodes_.size() + more > std::size_t(std::numeric_limits<NodeId>::max()))
    throw Error(ErrorCode::kLimit, "the octree would need 2^31 nodes or more: ask for larger sizes");
}

NodeId Forest::split(NodeId leaf) {
  require_room(8);
  const auto first = NodeId(nodes_.size());
  const Node parent = (*this)[leaf];
  nodes_.resize(nodes_.size() + 8,
                {-1, std::uint8_t(parent.exponent - 1), std::uint8_t(parent.flags & ~kHasCenter), 0});
  (*this)[leaf].link = first;
  return first;
}

NodeId Forest::make_room(std::size_t count) {
  require_room(count);
  const auto first = NodeId(nodes_.size());
  nodes_.resize_uninitialized(nodes_.size() + count);
  return first;
}

void Forest::graft(NodeId leaf, const Forest& tree, NodeId first) {
  const NodeId shift = first - 1;
  const auto moved = [shift](Node node) {
    if (!node.is_leaf()) node.link += shift;
    return node;
  };
  (*this)[leaf] = moved(tree[0]);
  for (NodeId n = 1; n < NodeId(tree.size()); ++n) (*this)[n + shift] = moved(tree[n]);
}

}  // namespace unsliver::octree
