/// \file
/// The oracle: Delaunay tetrahedra by CGAL, which decides exactly and breaks ties as we do.
#pragma once

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::oracle {

/// The finite Delaunay tetrahedra of the points, in no particular order.
inline std::vector<Tet> cgal_tets(const std::vector<Vec3>& points) {
  using Delaunay = CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  std::vector<Delaunay::Point> input;
  for (const Vec3& p : points) input.emplace_back(p.x, p.y, p.z);
  const Delaunay dt(input.begin(), input.end());
  std::vector<Tet> tets;
  for (auto cell = dt.finite_cells_begin(); cell != dt.finite_cells_end(); ++cell) {
    Tet t;
    for (int i = 0; i < 4; ++i) {
      const auto& p = cell->vertex(i)->point();
      t[std::size_t(i)] = {p.x(), p.y(), p.z()};
    }
    tets.push_back(t);
  }
  return tets;
}

}  // namespace unsliver::oracle
