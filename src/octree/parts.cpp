#include "octree/parts.hpp"

#include <algorithm>
#include <unordered_set>

namespace unsliver::octree {
namespace {

constexpr std::size_t kFewNodes = 1024;

class Cut {
 public:
  Cut(const Forest& forest, std::size_t most) : forest_(forest), most_(most) {}

  /// Notes the nodes of a subtree that are too large; returns how many nodes it has.
  std::size_t measure(NodeId n) {
    if (forest_[n].is_leaf()) return 1;
    std::size_t nodes = 1;
    const NodeId first = forest_[n].link;
    for (NodeId child = first; child < first + 8; ++child)
      nodes += forest_[child].is_leaf() ? 1 : measure(child);
    if (nodes > most_) large_.insert(n);
    return nodes;
  }

  /// Requires that the subtree was measured.
  void add_parts(const Cell& cell, std::vector<Part>& parts) const {
    const bool whole = !large_.contains(cell.node);
    parts.push_back({cell, whole});
    if (whole) return;
    for (int child = 0; child < 8; ++child) add_parts(forest_.child(cell, child), parts);
  }

 private:
  const Forest& forest_;
  const std::size_t most_;
  std::unordered_set<NodeId> large_;
};

}  // namespace

std::vector<Part> cut(const Forest& forest, std::size_t count) {
  Cut cut(forest, std::max(kFewNodes, forest.size() / count));
  std::vector<Part> parts;
  for_each_root(forest, [&](const Cell& root) {
    cut.measure(root.node);
    cut.add_parts(root, parts);
  });
  return parts;
}

Site site_of(const Forest& forest, const Cell& cell) {
  const Brick& brick = forest.brick();
  const auto number = [&](std::size_t axis, std::int64_t at) {
    return int((at - brick.lo[axis]) >> brick.exponent);
  };
  const int i = number(0, cell.x), j = number(1, cell.y), k = number(2, cell.z);
  Site site{root_block(forest, i, j, k), kFirstPlace};
  for (int exponent = brick.exponent - 1; exponent >= cell.exponent; --exponent) {
    site.block = child_block(forest, site.block, site.place);
    const auto upper = [&](std::size_t axis, std::int64_t at) {
      return int((at - brick.lo[axis]) >> exponent & 1);
    };
    site.place = place_of_child(upper(0, cell.x) | upper(1, cell.y) << 1 | upper(2, cell.z) << 2);
  }
  return site;
}

}  // namespace unsliver::octree
