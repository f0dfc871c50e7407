#include "geom/point_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>

namespace unsliver::geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  std::int64_t integer(std::int64_t lo, std::int64_t hi) {
    return lo + std::int64_t(bits_() % (std::uint64_t(hi - lo) + 1));
  }
  Vec3 point(std::int64_t bound) {
    const auto c = [&] { return double(integer(-bound, bound)); };
    const double x = c(), y = c();
    return {x, y, c()};
  }
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[bits_() % i]);
  }

 private:
  std::mt19937_64 bits_;
};

bool in_cube(const Vec3& center, double half, const Vec3& q) {
  return std::abs(q.x - center.x) <= half && std::abs(q.y - center.y) <= half &&
         std::abs(q.z - center.z) <= half;
}

/// Everything by looking at all points.
struct BruteForce {
  const std::vector<Vec3>& points;

  std::vector<double> distances_sq(const Vec3& w) const {
    std::vector<double> all;
    for (const Vec3& q : points) all.push_back(dist_sq(q, w));
    std::sort(all.begin(), all.end());
    return all;
  }
  std::set<VertexId> ids_in_cube(const Vec3& center, double half) const {
    std::set<VertexId> ids;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (in_cube(center, half, points[i])) ids.insert(static_cast<VertexId>(i));
    return ids;
  }
};

void expect_cube(const PointTree& tree, const BruteForce& all, const Vec3& center, double half) {
  const std::set<VertexId> expected = all.ids_in_cube(center, half);
  std::set<VertexId> found;
  tree.visit_cube(center, half, [&](VertexId id, const Vec3& point) {
    EXPECT_EQ(point, all.points[id]);
    EXPECT_TRUE(found.insert(id).second) << "visited twice";
    return false;
  });
  EXPECT_EQ(found, expected);
  EXPECT_EQ(tree.has_in_cube(center, half), !expected.empty());
  const VertexId first = tree.first_in_cube(center, half);
  ASSERT_EQ(first == kNoVertex, expected.empty());
  for (const VertexId id : expected) EXPECT_FALSE(lex_less(all.points[id], all.points[first]));
  EXPECT_EQ(expected.count(first), expected.empty() ? 0u : 1u);
}

void expect_distances(const PointTree& tree, const BruteForce& all, const Vec3& w, double radius) {
  std::vector<double> expected = all.distances_sq(w);
  const auto within = std::upper_bound(expected.begin(), expected.end(), radius * radius) - expected.begin();
  for (std::size_t count : {0, 1, 2, 3, 20})
    EXPECT_EQ(tree.has_within(w, radius, count), within >= std::ptrdiff_t(count)) << count;
  expected.insert(expected.end(), 2, kInfinity);
  const PointTree::TwoNearest nearest = tree.two_nearest(w);
  EXPECT_EQ(nearest.first_sq, expected[0]);
  EXPECT_EQ(nearest.second_sq, expected[1]);
  const PointTree::TwoNearest bounded = tree.two_nearest(w, radius * radius);
  EXPECT_EQ(bounded.first_sq, within > 0 ? expected[0] : kInfinity);
  EXPECT_EQ(bounded.second_sq, within > 1 ? expected[1] : kInfinity);
}

/// Queries at random, and such that points lie exactly on the cube's faces and the sphere.
void check(const std::vector<Vec3>& points, std::int64_t bound, int queries, Random& random) {
  const PointTree tree(points);
  const BruteForce all{points};
  EXPECT_EQ(tree.size(), points.size());
  for (int i = 0; i < queries; ++i) {
    Vec3 w = random.point(bound);
    double half = double(random.integer(0, std::int64_t{1} << random.integer(0, 46)) % (2 * bound + 1));
    if (!points.empty() && i % 2 == 0) {
      const Vec3& target = points[std::size_t(random.integer(0, std::int64_t(points.size()) - 1))];
      const double reach = double(random.integer(0, bound));
      if (i % 4 == 0) w = target + Vec3{double(random.integer(-1, 1)) * reach, reach, -reach};
      half = std::max({std::abs(target.x - w.x), std::abs(target.y - w.y), std::abs(target.z - w.z)});
      EXPECT_TRUE(tree.has_within(target, 0, 1));
      expect_distances(tree, all, {target.x + half, target.y, target.z}, half);
    }
    SCOPED_TRACE(testing::Message() << points.size() << " points, query " << i << " half " << half);
    expect_cube(tree, all, w, half);
    expect_distances(tree, all, w, half);
  }
}

int scaled(int count) { return std::getenv("UNSLIVER_LONG") ? 100 * count : count; }

TEST(PointTree, FewPointsOnASmallLatticeWithDuplicates) {
  Random random(1);
  for (int round = 0; round < scaled(200); ++round) {
    const std::int64_t bound = random.integer(1, 6);
    std::vector<Vec3> points(std::size_t(random.integer(0, 80)));
    for (Vec3& p : points) p = random.point(bound);
    check(points, bound + 2, 20, random);
  }
}

TEST(PointTree, UniformPointsOfTheWholeWorld) {
  Random random(2);
  constexpr std::int64_t kBound = std::int64_t{1} << 47;
  for (const int count : {1, 2, 16, 17, 18, 33, 1000, 3000}) {
    std::vector<Vec3> points(static_cast<std::size_t>(count));
    for (Vec3& p : points) p = random.point(kBound);
    check(points, kBound, scaled(100), random);
  }
}

TEST(PointTree, ClustersThatDifferByMillions) {
  Random random(3);
  constexpr std::int64_t kBound = std::int64_t{1} << 46;
  std::vector<Vec3> points;
  for (int cluster = 0; cluster < 20; ++cluster) {
    const Vec3 center = random.point(kBound);
    const std::int64_t size = std::int64_t{1} << random.integer(3, 40);
    for (int i = 0; i < 100; ++i) points.push_back(center + random.point(size));
  }
  check(points, kBound, scaled(400), random);
}

TEST(PointTree, PlanesLinesAndLatticesHaveTiesEverywhere) {
  Random random(4);
  std::vector<Vec3> line, plane, lattice;
  for (int i = 0; i < 1000; ++i) {
    line.push_back({double(i) * 8, 0, 0});
    plane.push_back({double(i % 32) * 8, double(i / 32) * 8, 8});
    lattice.push_back({double(i % 10) * 8, double(i / 10 % 10) * 8, double(i / 100) * 8});
  }
  for (std::vector<Vec3>* points : {&line, &plane, &lattice}) {
    random.shuffle(*points);
    check(*points, 100, scaled(150), random);
  }
}

TEST(PointTree, RealPlacesBetweenTheIntegers) {
  Random random(5);
  std::vector<Vec3> points(500);
  for (Vec3& p : points) p = random.point(50);
  const PointTree tree(points);
  for (int i = 0; i < scaled(300); ++i) {
    const Vec3 w = 0x1p-40 * random.point(std::int64_t{60} << 40);
    expect_distances(tree, {points}, w, std::sqrt(tree.two_nearest(w).second_sq));
    expect_distances(tree, {points}, w, dist(w, points[std::size_t(i) % points.size()]));
  }
}

TEST(PointTree, VisitsInAnOrderThatTheOrderOfThePointsDoesNotChange) {
  Random random(6);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.push_back({double(i % 9), double(i / 9 % 7), double(i / 63)});
  const auto visited = [&] {
    std::vector<Vec3> order;
    PointTree(points).visit_cube({4, 4, 4}, 3, [&](VertexId, const Vec3& p) {
      order.push_back(p);
      return false;
    });
    return order;
  };
  const std::vector<Vec3> expected = visited();
  EXPECT_GT(expected.size(), 100u);
  for (int i = 0; i < 10; ++i) {
    random.shuffle(points);
    EXPECT_EQ(visited(), expected);
  }
}

TEST(PointTree, VisitsEndWhenToldTo) {
  const std::vector<Vec3> points(100, Vec3{1, 2, 3});
  int visits = 0;
  PointTree(points).visit_cube({1, 2, 3}, 0, [&](VertexId, const Vec3&) { return ++visits == 3; });
  EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace unsliver::geom
