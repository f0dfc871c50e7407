/// \file
/// Which vertex is at a point?
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::refine {

/// World points with a vertex each, by open addressing in a table at most half full.
class PointLookup {
 public:
  /// kNoVertex where there is none.
  VertexId find(const Vec3& p) const { return entries_[slot_of(p)].v; }

  /// The vertex at p; where there was none, v from now on. Requires v to be other than kNoVertex.
  VertexId find_or_add(const Vec3& p, VertexId v) {
    if (2 * count_ >= entries_.size()) grow();
    Entry& entry = entries_[slot_of(p)];
    if (entry.v == kNoVertex) {
      entry = {p, v};
      ++count_;
    }
    return entry.v;
  }

  /// The same; says whether there was none.
  bool add(const Vec3& p, VertexId v) {
    const std::size_t before = count_;
    find_or_add(p, v);
    return count_ != before;
  }

  std::size_t bytes() const { return entries_.size() * sizeof(Entry); }

 private:
  struct Entry {
    Vec3 p;
    VertexId v = kNoVertex;
  };

  static std::size_t hash(const Vec3& p) {
    const auto mixed = std::uint64_t(std::int64_t(p.x)) * 0x9E3779B97F4A7C15 +
                       std::uint64_t(std::int64_t(p.y)) * 0xC2B2AE3D27D4EB4F +
                       std::uint64_t(std::int64_t(p.z)) * 0x165667B19E3779F9;
    return (mixed ^ mixed >> 29) * 0xBF58476D1CE4E5B9 >> 16;
  }
  /// Where p is, or where it would be put.
  std::size_t slot_of(const Vec3& p) const {
    std::size_t i = hash(p) & (entries_.size() - 1);
    while (entries_[i].v != kNoVertex && !(entries_[i].p == p)) i = (i + 1) & (entries_.size() - 1);
    return i;
  }
  void grow() {
    const std::vector<Entry> old = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
    for (const Entry& entry : old)
      if (entry.v != kNoVertex) entries_[slot_of(entry.p)] = entry;
  }

  std::vector<Entry> entries_ = std::vector<Entry>(1024);
  std::size_t count_ = 0;
};

}  // namespace unsliver::refine
