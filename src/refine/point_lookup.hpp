/// \file
/// Which vertex is at a point? Made for questions about millions of points, few of which are there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::refine {

/// World points with the kernel's vertex of each. Most points asked for are not there: a small bitmap says
/// so.
class PointLookup {
 public:
  /// All points, then finish(), then questions.
  void add(const Vec3& p, VertexId v) {
    entries_.push_back({p, v});
    bits_[hash(p) / 64] |= std::uint64_t{1} << hash(p) % 64;
  }
  void finish() { std::sort(entries_.begin(), entries_.end(), before); }
  /// kNoVertex where there is none.
  VertexId find(const Vec3& p) const {
    if ((bits_[hash(p) / 64] >> hash(p) % 64 & 1) == 0) return kNoVertex;
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{p, 0}, before);
    return at != entries_.end() && at->p == p ? at->v : kNoVertex;
  }

 private:
  struct Entry {
    Vec3 p;
    VertexId v;
  };
  static bool before(const Entry& a, const Entry& b) { return lex_less(a.p, b.p); }
  static std::size_t hash(const Vec3& p) {
    const auto mixed = std::uint64_t(std::int64_t(p.x)) * 0x9E3779B97F4A7C15 +
                       std::uint64_t(std::int64_t(p.y)) * 0xC2B2AE3D27D4EB4F +
                       std::uint64_t(std::int64_t(p.z)) * 0x165667B19E3779F9;
    return (mixed ^ mixed >> 29) * 0xBF58476D1CE4E5B9 >> (64 - kLogBits);
  }
  static constexpr int kLogBits = 20;

  std::vector<Entry> entries_;
  std::vector<std::uint64_t> bits_ = std::vector<std::uint64_t>((std::size_t{1} << kLogBits) / 64);
};

}  // namespace unsliver::refine
