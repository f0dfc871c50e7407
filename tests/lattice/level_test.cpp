#include "lattice/level.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"

namespace unsliver::lattice {
namespace {

using reference::Point;
using reference::Random;
using reference::to_vec;

Point difference(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
std::int64_t norm_sq(const Point& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

TEST(Level, MembershipIsTheDefinitionNearTheOrigin) {
  for (std::int64_t x = -9; x <= 9; ++x) {
    for (std::int64_t y = -9; y <= 9; ++y) {
      for (std::int64_t z = -9; z <= 9; ++z) {
        for (Level level = kMinLevel; level <= 10; ++level) {
          const Point p{x, y, z};
          EXPECT_EQ(on_lattice(level, to_vec(p)), reference::on_lattice(level, p))
              << to_vec(p) << " level " << level;
        }
      }
    }
  }
}

TEST(Level, MembershipIsTheDefinitionOfLatticePointsAndTheirNeighbours) {
  Random random(1);
  for (int i = 0; i < 200'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, kMaxLevel));
    Point p = random.lattice_point(level);
    EXPECT_TRUE(on_lattice(level, to_vec(p))) << to_vec(p) << " level " << level;
    const std::int64_t nudge = std::int64_t{1} << random.integer(0, level / 2);
    (random.integer(0, 1) ? p.x : p.z) += random.integer(0, 1) ? nudge : -nudge;
    EXPECT_EQ(on_lattice(level, to_vec(p)), reference::on_lattice(level, p))
        << to_vec(p) << " level " << level;
  }
}

TEST(Level, EachLatticeLiesInTheNextFiner) {
  Random random(2);
  for (Level level = kMinLevel; level < kMaxLevel; ++level) {
    int of_coarser = 0;
    for (int i = 0; i < 300; ++i) {
      EXPECT_TRUE(on_lattice(level, to_vec(random.lattice_point(level + 1)))) << "level " << level;
      of_coarser += on_lattice(level + 1, to_vec(random.lattice_point(level)));
    }
    EXPECT_LT(of_coarser, 300) << "level " << level << " is not finer than the next";
  }
}

TEST(Level, CanonicalLevelIsTheCoarsestThatHoldsThePoint) {
  Random random(3);
  const auto by_definition = [](const Point& p) {
    Level coarsest = kMinLevel;
    for (Level level = kMinLevel; level <= kMaxLevel; ++level) {
      if (reference::on_lattice(level, p)) coarsest = level;
    }
    return coarsest;
  };
  for (int i = 0; i < 20'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, kMaxLevel));
    for (const Point& p : {random.lattice_point(level), random.wide_point(), random.point(8)}) {
      EXPECT_EQ(canonical_level(to_vec(p)), by_definition(p)) << to_vec(p);
    }
  }
  EXPECT_EQ(canonical_level({0, 0, 0}), kMaxLevel);
  EXPECT_EQ(canonical_level({-0.0, 0, -0.0}), kMaxLevel);
  EXPECT_EQ(canonical_level({-1, 1, -1}), 2);
  EXPECT_EQ(canonical_level({-1, 1, 0}), 1);
}

TEST(Level, CanonicalLevelReachesTheEndOfTheRange) {
  const double half_range = 0x1p47, end = 0x1p48;
  EXPECT_EQ(canonical_level({-half_range, 0, 0}), 95);
  EXPECT_EQ(canonical_level({-half_range, half_range, half_range}), 96);
  EXPECT_EQ(canonical_level({end, -end, 0}), kMaxLevel);
}

// Proposition 4, e: the shortest of all lattice vectors in a cube that holds several of them.
TEST(Level, ShortestDistanceByBruteForce) {
  for (Level level = kMinLevel; level <= 6; ++level) {
    std::int64_t shortest_sq = std::numeric_limits<std::int64_t>::max();
    for (std::int64_t x = -8; x <= 8; ++x) {
      for (std::int64_t y = -8; y <= 8; ++y) {
        for (std::int64_t z = -8; z <= 8; ++z) {
          const std::int64_t length_sq = norm_sq({x, y, z});
          if (length_sq > 0 && reference::on_lattice(level, {x, y, z})) {
            shortest_sq = std::min(shortest_sq, length_sq);
          }
        }
      }
    }
    EXPECT_NEAR(shortest_distance(level), std::sqrt(double(shortest_sq)), 1e-14) << "level " << level;
  }
}

// Proposition 4, r: the farthest that a point of a cell can be from the lattice. The Voronoi vertices of
// SC_3 and BCC_3 have even coordinates, so integer points attain the maximum.
std::int64_t farthest_sq(Level level) {
  std::int64_t farthest = 0;
  for (Point p{0, 0, 0}; p.x < 8; ++p.x) {
    for (p.y = 0; p.y < 8; ++p.y) {
      for (p.z = 0; p.z < 8; ++p.z) {
        std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
        for (Point q{-8, 0, 0}; q.x <= 16; q.x += 4) {
          for (q.y = -8; q.y <= 16; q.y += 4) {
            for (q.z = -8; q.z <= 16; q.z += 4) {
              if (reference::on_lattice(level, q)) nearest = std::min(nearest, norm_sq(difference(p, q)));
            }
          }
        }
        farthest = std::max(farthest, nearest);
      }
    }
  }
  return farthest;
}

TEST(Level, CoveringRadiusByBruteForce) {
  for (const Level level : {6, 7}) {
    EXPECT_NEAR(covering_radius(level), std::sqrt(double(farthest_sq(level))), 1e-14) << "level " << level;
  }
}

TEST(Level, RadiiDoubleEverySecondLevel) {
  for (Level level = kMinLevel; level + 2 <= kMaxLevel; ++level) {
    EXPECT_EQ(shortest_distance(level + 2), 2 * shortest_distance(level));
    EXPECT_EQ(covering_radius(level + 2), 2 * covering_radius(level));
    EXPECT_LT(covering_radius(level), covering_radius(level + 1));
  }
}

Level coarsest_by_scan(double radius) {
  Level coarsest = kMinLevel - 1;
  for (Level level = kMinLevel; level <= kMaxLevel; ++level) {
    if (covering_radius(level) <= radius) coarsest = level;
  }
  return coarsest;
}

TEST(Level, CoarsestWithinIsAScan) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (Level level = kMinLevel; level <= kMaxLevel; ++level) {
    const double r = covering_radius(level);
    EXPECT_EQ(coarsest_within(r), level);
    EXPECT_EQ(coarsest_within(std::nextafter(r, 0)), level - 1);
    EXPECT_EQ(coarsest_within(std::nextafter(r, infinity)), level);
  }
  Random random(4);
  for (int i = 0; i < 10'000; ++i) {
    const double radius = std::ldexp(random.real(0.5, 1), int(random.integer(-3, 52)));
    EXPECT_EQ(coarsest_within(radius), coarsest_by_scan(radius)) << radius;
  }
  EXPECT_EQ(coarsest_within(infinity), kMaxLevel);
  for (const double none : {0.0, -1.0, -infinity, 5e-324, std::nan("")}) {
    EXPECT_EQ(coarsest_within(none), kMinLevel - 1) << none;
  }
}

}  // namespace
}  // namespace unsliver::lattice
