/// \file
/// Tetrahedra that wait for their turn, and the queue of the thrifty strategy.
#pragma once

#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

/// A finite tetrahedron in a queue is the one that its last corner made in its slot: a slot is filled at most
/// once an insertion, and the kernel puts the new vertex last.
struct Queued {
  TetId slot;
  VertexId last_corner;
};

template <class R>
Queued queued(const R& r, TetId t) {
  return {t, r.mesh().tet(t).v[3]};
}

template <class R>
bool still_there(const R& r, const Queued& entry) {
  return r.mesh().is_finite(entry.slot) && r.mesh().tet(entry.slot).v[3] == entry.last_corner;
}

/// Smallest circumradius first, to one percent; last in first out among equals. Both operations are O(1).
class RadiusQueue {
 public:
  /// Numbers that are no squared radii come last.
  void push(const Queued& entry, double radius_sq) {
    const std::size_t bucket = bucket_of(radius_sq);
    buckets_[bucket].push_back(entry);
    lowest_ = std::min(lowest_, bucket);
  }
  /// The next entry, or nothing when the queue is empty.
  std::optional<Queued> pop() {
    while (lowest_ < kBuckets && buckets_[lowest_].empty()) ++lowest_;
    if (lowest_ == kBuckets) return std::nullopt;
    const Queued entry = buckets_[lowest_].back();
    buckets_[lowest_].pop_back();
    return entry;
  }

 private:
  static constexpr int kBitsOfFraction = 5;  // of the square
  static constexpr std::size_t kBuckets = std::size_t{200} << kBitsOfFraction;

  static std::size_t bucket_of(double radius_sq) {
    const auto exponent_and_fraction = std::bit_cast<std::uint64_t>(radius_sq) >> (52 - kBitsOfFraction);
    const std::uint64_t of_one = std::uint64_t{1023} << kBitsOfFraction;
    return std::min<std::size_t>(exponent_and_fraction - std::min(exponent_and_fraction, of_one),
                                 kBuckets - 1);
  }

  std::array<std::vector<Queued>, kBuckets> buckets_;
  std::size_t lowest_ = kBuckets;
};

}  // namespace unsliver::refine
