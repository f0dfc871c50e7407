/// \file
/// The order of bulk insertion: a biased randomized insertion order (Amenta, Choi, Rote) with each round
/// along a Hilbert curve, so that consecutive points are neighbours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::delaunay {

/// Position of p along a Hilbert curve of 2^63 cells over the box.
std::uint64_t hilbert_index(const Vec3& p, const Box3& box);

/// A permutation of 0 .. points.size() - 1, the same on every platform.
std::vector<std::uint32_t> insertion_order(std::span<const Vec3> points);

}  // namespace unsliver::delaunay
