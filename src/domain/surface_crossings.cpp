#include "domain/surface_crossings.hpp"

#include <algorithm>

#include "geom/triangle_bvh.hpp"
#include "geom/triangle_shape.hpp"

namespace unsliver::domain {
namespace {

using geom::Triangle;
using Corners = std::array<VertexId, 3>;

struct Item {
  std::size_t id = 0;
  Corners corners{};
  Triangle shape;
  Box3 box;
};

/// Triangles of positive area.
std::vector<Item> make_items(const std::vector<Vec3>& points, const std::vector<Corners>& triangles) {
  std::vector<Item> items;
  items.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Corners& v = triangles[t];
    const Triangle shape{points[v[0]], points[v[1]], points[v[2]]};
    if (norm_sq(geom::area_vector(shape)) > 0) items.push_back({t, v, shape, geom::bounding_box(shape)});
  }
  return items;
}

geom::BoxTree sort_into_tree(std::vector<Item>& items) {
  std::vector<Box3> boxes;
  boxes.reserve(items.size());
  for (const Item& item : items) boxes.push_back(item.box);
  geom::BoxTree tree(boxes, 8);
  std::vector<Item> sorted;
  sorted.reserve(items.size());
  for (const std::uint32_t i : tree.order()) sorted.push_back(items[i]);
  items = std::move(sorted);
  return tree;
}

bool cross(Item a, Item b) {
  if (!a.box.overlaps(b.box)) return false;
  int shared = 0;  // common corners, moved to the front of both
  for (int i = 0; i < 3; ++i) {
    const auto same = std::find(b.corners.begin() + shared, b.corners.end(), a.corners[i]);
    if (same == b.corners.end()) continue;
    const auto j = same - b.corners.begin();
    std::swap(a.corners[shared], a.corners[i]);
    std::swap(a.shape[shared], a.shape[i]);
    std::swap(b.corners[shared], b.corners[j]);
    std::swap(b.shape[shared], b.shape[j]);
    ++shared;
  }
  return shared < 3 && geom::triangles_cross(a.shape, b.shape, shared);
}

}  // namespace

bool find_crossings(const std::vector<Vec3>& points, const std::vector<Corners>& triangles, std::size_t most,
                    const std::function<void(std::size_t, std::size_t)>& found) {
  std::vector<Item> items = make_items(points, triangles);
  const geom::BoxTree tree = sort_into_tree(items);
  std::size_t count = 0;
  const auto compare = [&](std::uint32_t i, std::uint32_t j) {
    if (!cross(items[i], items[j])) return;
    ++count;
    found(std::min(items[i].id, items[j].id), std::max(items[i].id, items[j].id));
  };
  for (const auto& leaf : tree.nodes()) {
    if (!leaf.is_leaf()) continue;
    tree.walk([&](const geom::BoxTree::Node& node) { return node.box.overlaps(leaf.box); },
              [&](std::uint32_t first, std::uint32_t size) {
                for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
                  for (std::uint32_t j = std::max(first, i + 1); j < first + size; ++j) compare(i, j);
                return false;
              });
    if (count >= most) return false;
  }
  return true;
}

}  // namespace unsliver::domain
