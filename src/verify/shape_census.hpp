/// \file
/// Tetrahedra that differ by a translation only count as one shape, to be judged once.
#pragma once

#include <unordered_map>

#include "verify/stream_context.hpp"

namespace unsliver::verifier {

/// From corner 0 to corners 1, 2, 3.
using Differences = std::array<Row<std::int64_t>, 3>;

struct DifferencesHash {
  std::size_t operator()(const Differences& d) const {
    std::uint64_t h = 0;
    for (const auto& row : d)
      for (const std::int64_t x : row) {
        h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
      }
    return static_cast<std::size_t>(h);
  }
};

class ShapeCensus {
 public:
  /// Of how many shapes it keeps count.
  static constexpr std::size_t kMostShapes = std::size_t{1} << 20;

  /// Requires: !is_full().
  void add(const Differences& shape, std::uint64_t tet) {
    Count& count = shapes_.try_emplace(shape, Count{tet, 0}).first->second;
    ++count.tets;
  }
  bool is_full() const { return shapes_.size() >= kMostShapes; }
  std::size_t size() const { return shapes_.size(); }

  /// Judges each shape. Findings "orientation", "dihedral" and "radius-edge" name the first tetrahedron of
  /// the shape and how many more there are; fills the achieved extremes, the shapes and the decision
  /// counts.
  void judge(const StreamContext& context) const;

  /// Six times the sum of the signed volumes, in cubic units of the frame.
  BigInt six_volumes() const;

 private:
  struct Count {
    std::uint64_t first_tet, tets;
  };
  std::unordered_map<Differences, Count, DifferencesHash> shapes_;
};

}  // namespace unsliver::verifier
