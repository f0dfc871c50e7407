/// \file
/// What depends on a tetrahedron's shape alone, computed once for each shape that comes again and again.
///
/// Lattice meshes repeat a few thousand shapes, size and order of corners included, and the differences of
/// their coordinates are exact: bit for bit the same wherever the tetrahedron lies.
#pragma once

#include <bit>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::geom {

/// Remembers a Value for each of up to 4096 shapes. A shape is the six edge vectors as doubles compute them,
/// compared bit for bit, so a remembered value is exactly what a new computation would give. Where shapes
/// seldom repeat, it asks its memory seldom and costs a few per cent.
template <class Value>
class ShapeCache {
 public:
  ShapeCache() : entries_(kEntries) {}

  /// `measure(t)`, or what it gave for an earlier tetrahedron of the same shape; valid until the next call.
  /// Requires finite edges, and that the value depends on nothing but differences of two corners.
  template <class Measure>
  const Value& get(Tet t, const Measure& measure) {
    if (!worth_asking()) return rest_value_ = measure(Tet(t));
    const Shape shape = shape_of(t);
    Entry& entry = entries_[slot_of(shape)];
    if (same(entry.shape, shape)) {
      ++hits_;
      return entry.value;
    }
    entry.shape = shape;
    return entry.value = measure(Tet(t));  // a copy, so that t may stay in registers
  }

 private:
  static constexpr int kLogEntries = 12;
  static constexpr std::size_t kEntries = std::size_t{1} << kLogEntries;
  static constexpr int kRound = 4096, kRestRounds = 8;

  /// The edges' x and y in pairs, then their z: processors stall when they read in other portions than they
  /// have just written, and this is how compilers write.
  using Shape = std::array<std::uint64_t, 18>;

  struct Entry {
    Entry() { shape.fill(~std::uint64_t{0}); }  // NaN, so no tetrahedron's
    Shape shape;
    Value value;
  };

  static Shape shape_of(const Tet& t) {
    const Vec3 edges[] = {t[1] - t[0], t[2] - t[0], t[3] - t[0], t[2] - t[1], t[3] - t[1], t[3] - t[2]};
    std::array<double, 18> numbers;
    for (int i = 0; i < 6; ++i) {
      numbers[2 * i] = edges[i].x;
      numbers[2 * i + 1] = edges[i].y;
      numbers[12 + i] = edges[i].z;
    }
    return std::bit_cast<Shape>(numbers);
  }

  /// From three edges: but for rounding, they determine the others.
  static std::size_t slot_of(const Shape& shape) {
    constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;
    std::uint64_t sum = 0, factor = kOdd;
    for (const int i : {0, 1, 2, 3, 4, 5, 12, 13, 14}) {
      sum += (shape[i] ^ shape[i] >> 32) * factor;
      factor *= kOdd;
    }
    return sum >> (64 - kLogEntries);
  }

  /// Without a branch for each number: they nearly always agree.
  static bool same(const Shape& a, const Shape& b) {
    std::uint64_t difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
    return difference == 0;
  }

  /// Counts calls in rounds. A round with few hits is followed by a longer rest.
  bool worth_asking() {
    if (calls_left_-- > 0) return asking_;
    asking_ = !asking_ || hits_ >= kRound / 4;
    calls_left_ = (asking_ ? 1 : kRestRounds) * kRound - 1;
    hits_ = 0;
    return asking_;
  }

  std::vector<Entry> entries_;
  Value rest_value_;
  bool asking_ = true;
  int calls_left_ = kRound, hits_ = 0;
};

}  // namespace unsliver::geom
