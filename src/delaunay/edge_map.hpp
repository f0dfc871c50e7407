/// \file
/// Pairs the facets around a new vertex: directed edge (a, b) of the cavity's boundary meets (b, a).
///
/// A cavity's boundary is a closed oriented surface, so every directed edge occurs once and its reverse once.
/// Up to kSmall boundary vertices a flat table indexed by local vertex numbers does it without clearing or
/// probing (each entry that is read was written for this cavity); larger cavities, which lattices do produce,
/// sort.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "delaunay/store.hpp"

namespace unsliver::delaunay {

class EdgeMap {
 public:
  static constexpr std::uint32_t kSmall = 64;

  /// Starts a cavity with `vertex_count` boundary vertices, numbered 0 .. vertex_count - 1 by the caller.
  void start(std::uint32_t vertex_count) {
    small_ = vertex_count <= kSmall;
    large_.clear();
  }

  /// Facet f of a new tetrahedron lies on the directed edge (a, b).
  void add(std::uint32_t a, std::uint32_t b, Facet f) {
    if (small_)
      table_[a * kSmall + b] = f;
    else
      large_.push_back({key(a, b), f});
  }

  /// Call after the last add.
  void finish() {
    if (!small_) std::sort(large_.begin(), large_.end());
  }

  /// The facet on the directed edge (a, b).
  Facet find(std::uint32_t a, std::uint32_t b) const {
    if (small_) return table_[a * kSmall + b];
    return std::lower_bound(large_.begin(), large_.end(), Entry{key(a, b), 0})->facet;
  }

 private:
  struct Entry {
    std::uint64_t key;
    Facet facet;
    bool operator<(const Entry& other) const { return key < other.key; }
  };
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }

  bool small_ = true;
  Facet table_[kSmall * kSmall];
  std::vector<Entry> large_;
};

}  // namespace unsliver::delaunay
