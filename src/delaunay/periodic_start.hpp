/// \file
/// The first tetrahedralization of a torus.
#pragma once

#include <span>

#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {

/// The Delaunay tetrahedralization of these points and all their copies, folded from one of copies in R^3;
/// point i becomes vertex i + 1. Costs (1 + p/x)(1 + p/y)(1 + p/z) insertions a point, for periods x, y and
/// z, the shortest p. Requires distinct integer points in [0, period), which leave no empty ball of a
/// diameter of half the shortest period or more.
PeriodicTriangulation periodic_start(const Torus& torus, std::span<const Vec3> points);

}  // namespace unsliver::delaunay
