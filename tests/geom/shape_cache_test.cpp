#include "geom/shape_cache.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geom/tetrahedron.hpp"

namespace unsliver::geom {
namespace {

/// Everything that callers ask of a shape, computed anew.
struct Measured {
  std::array<double, 6> cotangents{};
  double volume = 0, ratio = 0;
  friend bool operator==(const Measured&, const Measured&) = default;
};

Measured measured(const Tet& t) { return {dihedral_cotangents(t), volume(t), radius_edge_ratio(t)}; }

class Counted {
 public:
  Measured of(const Tet& t) {
    return cache_.get(t, [this](const Tet& t) {
      ++count;
      return measured(t);
    });
  }
  int count = 0;

 private:
  ShapeCache<Measured> cache_;
};

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  int integer(int count) { return int(bits_() % unsigned(count)); }
  double real() { return 0x1p-53 * double(bits_() >> 11); }
  Tet tet() {
    Tet t;
    for (Vec3& p : t) p = {real(), real(), real()};
    return t;
  }

 private:
  std::mt19937_64 bits_;
};

Tet moved(Tet t, const Vec3& by) {
  for (Vec3& p : t) p = p + by;
  return t;
}

TEST(ShapeCache, RepeatedShapesAreMeasuredOnce) {
  Random random(1);
  Counted cache;
  const Tet shapes[] = {{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 1, -1}, Vec3{1, 1, 1}},
                        {Vec3{0, 0, 0}, Vec3{0, 2, 0}, Vec3{-1, 1, 1}, Vec3{1, 1, 1}},
                        {Vec3{0, 2, 1}, Vec3{2, 0, 1}, Vec3{3, 2, 1}, Vec3{2, 4, 3}}};
  for (int i = 0; i < 100000; ++i) {
    const double size = std::ldexp(1.0, random.integer(4));
    Tet t = shapes[random.integer(3)];
    for (Vec3& p : t) p = size * p;
    t = moved(t, {double(random.integer(999)), double(random.integer(999)), double(random.integer(999))});
    ASSERT_EQ(cache.of(t), measured(t));
  }
  EXPECT_LE(cache.count, 40) << "12 shapes, of which few may share a slot";
}

// Rounding makes edges of one tetrahedron differ from those of another whose first three agree.
TEST(ShapeCache, EqualEdgesAtOneCornerAreNotEnough) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Counted cache;
    const Tet t = random.tet();
    for (int j = 0; j < 20; ++j) {
      const Tet other = moved(t, 1e-17 * Vec3{double(random.integer(99)), 0, double(random.integer(99))});
      ASSERT_EQ(cache.of(other), measured(other)) << "tetrahedron " << i << ", move " << j;
    }
  }
}

TEST(ShapeCache, NoTetrahedronMatchesAnUnusedEntry) {
  Counted cache;
  EXPECT_EQ(cache.of(Tet{}), measured(Tet{})) << "all edges 0";
  EXPECT_EQ(cache.count, 1);
}

TEST(ShapeCache, ZerosOfEitherSignAreTwoShapes) {
  ShapeCache<double> cache;
  const auto sign = [](const Tet& t) { return std::copysign(1.0, t[1].x - t[0].x); };
  const Tet plus = {Vec3{0, 0, 0}, Vec3{0.0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  const Tet minus = {Vec3{0, 0, 0}, Vec3{-0.0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(cache.get(plus, sign), 1);
    EXPECT_EQ(cache.get(minus, sign), -1);
  }
}

TEST(ShapeCache, IsRightWhetherOrNotShapesRepeatAndRecovers) {
  Random random(3);
  Counted cache;
  std::vector<Tet> few(50);
  for (Tet& t : few) t = random.tet();
  const auto run = [&](int calls, bool repeat) {
    const int before = cache.count;
    for (int i = 0; i < calls; ++i) {
      const Tet t = repeat ? few[random.integer(50)] : random.tet();
      EXPECT_EQ(cache.of(t), measured(t));
    }
    return cache.count - before;
  };
  EXPECT_LE(run(20000, true), 2000);
  EXPECT_EQ(run(50000, false), 50000);
  EXPECT_LE(run(50000, true), 40000) << "it looks again after a rest";
  EXPECT_LE(run(20000, true), 2000);
}

}  // namespace
}  // namespace unsliver::geom
