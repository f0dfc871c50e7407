#include "io/point_merger.hpp"

#include <bit>

namespace unsliver::io {
namespace {

std::uint64_t mixed(std::uint64_t h) {
  h ^= h >> 32;
  h *= 0x9e3779b97f4a7c15u;
  h ^= h >> 29;
  return h;
}

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  // Adding 0 turns -0 into 0: equal numbers, equal hash.
  for (const double c : {p.x, p.y, p.z})
    h = mixed(h * 0xbf58476d1ce4e5b9u + std::bit_cast<std::uint64_t>(c + 0.0));
  return h;
}

}  // namespace

std::size_t PointMerger::slot_of(const Vec3& point) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(point) & mask;
  while (slots_[slot] != kNoVertex && !(points_[slots_[slot]] == point)) slot = (slot + 1) & mask;
  return slot;
}

void PointMerger::grow() {
  slots_.assign(2 * slots_.size(), kNoVertex);
  for (std::size_t i = 0; i < points_.size(); ++i) slots_[slot_of(points_[i])] = static_cast<VertexId>(i);
}

VertexId PointMerger::add(const Vec3& point) {
  if (2 * points_.size() >= slots_.size()) grow();
  VertexId& id = slots_[slot_of(point)];
  if (id == kNoVertex) {
    id = static_cast<VertexId>(points_.size());
    points_.push_back(point);
  }
  return id;
}

}  // namespace unsliver::io
