// Our tetrahedralization against CGAL's: the same set of tetrahedra, ties included, in any insertion order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "cgal.hpp"
#include "delaunay/point_sets.hpp"
#include "delaunay/triangulation.hpp"

namespace unsliver::delaunay {
namespace {

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
  TetSet tets;
  for (const Tet& t : oracle::cgal_tets(points)) tets.insert(sorted(t));
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
