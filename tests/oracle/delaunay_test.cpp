// Our tetrahedralization against CGAL's: the same set of tetrahedra, ties included, in any insertion order.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "delaunay/point_sets.hpp"
#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {
namespace {

using Cgal = CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

struct TetLess {
  bool operator()(const Tet& a, const Tet& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lex_less);
  }
};
using TetSet = std::set<Tet, TetLess>;

Tet sorted(Tet t) {
  std::sort(t.begin(), t.end(), lex_less);
  return t;
}

TetSet ours(const std::vector<Vec3>& points) {
  Triangulation dt;
  dt.insert_all(points);
  TetSet tets;
  for (TetId t = 0; t < dt.slot_count(); ++t)
    if (dt.is_finite(t)) tets.insert(sorted(dt.corners(t)));
  return tets;
}

TetSet cgals(const std::vector<Vec3>& points) {
  std::vector<Cgal::Point> input;
  for (const Vec3& p : points) input.emplace_back(p.x, p.y, p.z);
  const Cgal dt(input.begin(), input.end());
  TetSet tets;
  for (auto cell = dt.finite_cells_begin(); cell != dt.finite_cells_end(); ++cell) {
    Tet t;
    for (int i = 0; i < 4; ++i) {
      const auto& p = cell->vertex(i)->point();
      t[i] = {p.x(), p.y(), p.z()};
    }
    tets.insert(sorted(t));
  }
  return tets;
}

int seeds() { return std::getenv("UNSLIVER_LONG") != nullptr ? 100 : 5; }

TEST(DelaunayOracle, SameTetrahedraAsCgal) {
  for (int seed = 1; seed <= seeds(); ++seed)
    for (const auto& set : test::point_sets(static_cast<std::uint64_t>(seed))) {
      SCOPED_TRACE(set.name + ", seed " + std::to_string(seed));
      EXPECT_EQ(ours(set.points), cgals(set.points));
    }
}

TEST(DelaunayOracle, SameTetrahedraAsCgalInAnyOrder) {
  test::Random random(17);
  for (auto set : test::point_sets(23)) {
    SCOPED_TRACE(set.name);
    const TetSet expected = cgals(set.points);
    for (int trial = 0; trial < 3; ++trial) {
      test::shuffle(set.points, random);
      Triangulation dt;
      for (const Vec3& p : set.points) dt.insert(p);
      TetSet tets;
      for (TetId t = 0; t < dt.slot_count(); ++t)
        if (dt.is_finite(t)) tets.insert(sorted(dt.corners(t)));
      EXPECT_EQ(tets, expected) << "shuffle " << trial;
    }
  }
}

TEST(DelaunayOracle, SameTetrahedraAsCgalOnALargeLattice) {
  for (const bool centres : {false, true}) {
    const auto points = test::lattice_points(20, 64, centres);
    EXPECT_EQ(ours(points), cgals(points)) << (centres ? "BCC" : "SC");
  }
}

}  // namespace
}  // namespace unsliver::delaunay
