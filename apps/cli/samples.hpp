/// \file
/// Points that a superset mesh must cover, for the verifier. Deterministic.
#pragma once

#include <cstddef>
#include <vector>

#include "unsliver/domain.hpp"

namespace unsliver::cli {

/// About `count` points of the domain, drawn evenly from its bounds and from its boundary's inner side.
std::vector<Vec3> domain_samples(const Domain& domain, std::size_t count);

/// Every vertex of a triangle.
std::vector<Vec3> surface_vertices(const TriangleMesh& surface);

/// `count` points spread evenly by area. Their barycentric weights are multiples of 2^-16, so that on planes
/// with short coordinates, where a facet of the mesh may lie in the very same plane, they are not rounded off
/// it.
std::vector<Vec3> surface_samples(const TriangleMesh& surface, std::size_t count);

/// How far rounding may have taken a sample off its surface: a mesh may end in the very plane of a triangle.
double sample_rounding(const std::vector<Vec3>& samples);

}  // namespace unsliver::cli
