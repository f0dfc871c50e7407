/// \file
/// The first tetrahedralization of a torus.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

/// The Delaunay tetrahedralization of these points and all their copies, folded from one of copies in R^3;
/// point i becomes vertex i + 1. Nothing where `is_small` rejects one of the tetrahedra: it must reject all
/// with a circumsphere of a diameter of half the shortest period or more. Costs (1 + p/x)(1 + p/y)(1 + p/z)
/// insertions a point, for periods x, y and z, the shortest p. Requires distinct integer points in
/// [0, period).
std::optional<PeriodicTriangulation> periodic_start(const Torus& torus, std::span<const Vec3> points,
                                                    const std::function<bool(const Tet&)>& is_small);

}  // namespace unsliver::delaunay
