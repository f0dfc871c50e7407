// Which boxes cubes fill exactly, decided without error, and what is proposed in place of the others.
#include "octree/box_lattice.hpp"

#include <gtest/gtest.h>

#include <random>

#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

Vec3 far_corner(const BoxLattice& lattice) {
  Vec3 q;
  for (int axis = 0; axis < 3; ++axis)
    q[axis] = std::ldexp(double(lattice.brick.count[std::size_t(axis)]), lattice.brick.exponent);
  return lattice.world.to_caller(q);
}

double root_side(const BoxLattice& lattice) {
  return std::ldexp(lattice.world.unit(), lattice.brick.exponent);
}

void expect_exact(const Box3& box, const std::vector<BoxLattice>& lattices) {
  ASSERT_FALSE(lattices.empty());
  for (const BoxLattice& lattice : lattices) {
    EXPECT_EQ(lattice.world.to_caller({0, 0, 0}), box.lo);
    EXPECT_EQ(far_corner(lattice), box.hi);
    EXPECT_GT(2 * lattice.brick.exponent, lattice.world.finest_level() + 20);
  }
}

/// The error that lattices_of throws.
Error refusal(const Box3& box) {
  try {
    lattices_of(box);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::kInternal, ""};
}

TEST(BoxLattice, FillsMultiplesOfShortNumbers) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    SCOPED_TRACE(trial);
    const double d = double(1 + 2 * (random() % 64));
    const double side = std::ldexp(d, int(random() % 60) - 30);
    Box3 box;
    double count[3];
    for (int axis = 0; axis < 3; ++axis) {
      count[axis] = double(1 + random() % 12);
      box.lo[axis] = side * (double(random() % 4097) - 2048) / 64;
      box.hi[axis] = box.lo[axis] + count[axis] * side;
    }
    const auto lattices = lattices_of(box);
    expect_exact(box, lattices);
    bool has_side = false;
    for (const BoxLattice& lattice : lattices) {
      const double ratio = root_side(lattice) / side;
      has_side = has_side || (ratio >= 1 && std::fmod(ratio, 1) == 0);
    }
    EXPECT_TRUE(has_side);
  }
}

TEST(BoxLattice, TheLargestRootsComeFirst) {
  const auto lattices = lattices_of({{0, 0, 0}, {30, 60, 90}});
  ASSERT_EQ(lattices.size(), 4u);  // 1, 3, 5, 15
  EXPECT_EQ(root_side(lattices[0]), 30);
  EXPECT_EQ(lattices[0].brick.count, (std::array{1, 2, 3}));
  EXPECT_EQ(root_side(lattices[3]), 2);
}

TEST(BoxLattice, ProposesTheNearestBoxForOthers) {
  for (const Box3& box : {Box3{{0, 0, 0}, {0.3, 0.3, 0.3}}, Box3{{0.1, 0.2, 0.3}, {1, 2, 3}},
                          Box3{{0, 0, 0}, {1, 1, 1.0 / 3}}, Box3{{-1e-3, 0, 5}, {1e-3, 0.0017, 5.003}},
                          Box3{{0, 0, 0}, {257, 257, 256.9}}, Box3{{0, 0, 0}, {3.1e-200, 3e-200, 2e-200}},
                          Box3{{0, 0, 0}, {1, 1, 1 + 0x1p-40}}, Box3{{1 + 0x1p-50, 0, 0}, {2, 1, 1}}}) {
    const Error error = refusal(box);
    SCOPED_TRACE(error.what());
    ASSERT_EQ(error.places.size(), 2u);
    const Box3 near{error.places[0], error.places[1]};
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(near.size()[axis] / box.size()[axis], 1, 1.001e-2);
      EXPECT_NEAR(near.lo[axis], box.lo[axis], 1e-3 * box.longest_side());
    }
    expect_exact(near, lattices_of(near));
  }
}

TEST(BoxLattice, RefusesWhatIsFarFromTheOriginOrNeedsTooMany) {
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 1, 0x1p-12}}).code(), ErrorCode::kLimit);
  EXPECT_EQ(refusal({{0.1, 0, 0}, {1, 1, 1}}).code(), ErrorCode::kUnsupported);
  EXPECT_EQ(refusal({{1e16, 0, 0}, {1e16 + 2, 1e-3, 1e-3}}).code(), ErrorCode::kUnsupported);
  EXPECT_EQ(refusal({{0, 0, 0}, {1, 1e-300, 1}}).code(), ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace unsliver::octree
