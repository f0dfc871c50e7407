#include "lattice/input_sites.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "reference.hpp"
#include "unsliver/error.hpp"

namespace unsliver::lattice {
namespace {

using reference::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 random_place(Random& random, double half) {
  const double x = random.real(-half, half), y = random.real(-half, half);
  return {x, y, random.real(-half, half)};
}

std::vector<Vec3> random_points(Random& random, std::size_t count, double half) {
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = random_place(random, half);
  return points;
}

double closest_by_brute_force(const std::vector<Vec3>& points, double scale) {
  double best = kInfinity;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(points[i] == points[j]))
        best = std::min(best, dist((1 / scale) * points[i], (1 / scale) * points[j]));
  return best * scale;
}

void expect_consistent(const InputSites& sites, const std::vector<Vec3>& points) {
  ASSERT_EQ(sites.site_of.size(), points.size());
  std::map<std::array<double, 3>, VertexId> known;
  for (VertexId id = 0; id < points.size(); ++id) {
    const std::array<double, 3> key{points[id].x + 0.0, points[id].y + 0.0, points[id].z + 0.0};
    const auto [place, is_new] = known.emplace(key, VertexId(known.size()));
    EXPECT_EQ(sites.site_of[id], place->second);
    EXPECT_TRUE(!is_new || sites.first_point[place->second] == id);
  }
  EXPECT_EQ(sites.first_point.size(), known.size());
  EXPECT_EQ(sites.duplicate_count(), points.size() - known.size());
}

Error error_of(const std::vector<Vec3>& points, double extent) {
  try {
    (void)find_sites(points, extent);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::kInternal, "no error");
}

TEST(InputSites, MergesEqualPointsAndKeepsTheirOrder) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    std::vector<Vec3> points(std::size_t(random.integer(0, 60)));
    for (Vec3& p : points) p = reference::to_vec(random.point(2));
    const InputSites sites = find_sites(points, 1);
    expect_consistent(sites, points);
    std::size_t merged = 0;
    for (const auto& group : sites.merged_groups()) {
      merged += group.size() - 1;
      for (const VertexId id : group) EXPECT_EQ(points[id], points[group[0]]);
      EXPECT_TRUE(std::is_sorted(group.begin(), group.end()));
      EXPECT_GE(group.size(), 2U);
    }
    EXPECT_EQ(merged, sites.duplicate_count());
    EXPECT_EQ(sites.note().empty(), merged == 0);
  }
}

TEST(InputSites, NotesWhatWasMerged) {
  const std::vector<Vec3> points{{0, 0, 1}, {1, 2, 3}, {-0.0, 0, 1}, {1, 2, 3}};
  const InputSites sites = find_sites(points, 1);
  EXPECT_EQ(sites.site_of, (std::vector<VertexId>{0, 1, 0, 1}));
  EXPECT_EQ(sites.merged_groups(), (std::vector<std::vector<VertexId>>{{0, 2}, {1, 3}}));
  EXPECT_EQ(sites.note(),
            "2 of 4 points repeat an earlier one (the first is point 2, which equals point 0); equal points "
            "become one vertex.");
}

TEST(InputSites, FewOrEqualPointsHaveNoClosestPair) {
  EXPECT_EQ(find_sites({}, 1).closest, kInfinity);
  EXPECT_EQ(find_sites(std::vector<Vec3>{{1, 2, 3}}, 1).closest, kInfinity);
  const InputSites same = find_sites(std::vector<Vec3>(1000, Vec3{1, 2, 3}), 0);
  EXPECT_EQ(same.closest, kInfinity);
  EXPECT_EQ(same.first_point.size(), 1U);
  EXPECT_EQ(same.max_step(), kInfinity);
}

TEST(InputSites, FindsTheLeastDistanceAtAnyScale) {
  Random random(2);
  for (const double scale : {0x1p-960, 0x1p-300, 1.0, 0x1p60, 0x1p990}) {
    for (int round = 0; round < 20; ++round) {
      const std::vector<Vec3> points = random_points(random, 100, scale);
      const double expected = closest_by_brute_force(points, scale);
      EXPECT_NEAR(find_sites(points, scale).closest / scale, expected / scale, 1e-15 * expected / scale);
    }
  }
}

TEST(InputSites, RefusesPointsThatAreTooClose) {
  Random random(3);
  for (const double extent : {1e-200, 1.0, 3e7}) {
    std::vector<Vec3> points = random_points(random, 1000, extent / 4);
    points[700] = points[30] + Vec3{0, 0.999e-11 * extent, 0};
    points[800] = points[31] + Vec3{0, 0, 0.5e-11 * extent};
    const Error error = error_of(points, extent);
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.ids, (std::vector<std::int64_t>{31, 800}));
    EXPECT_EQ(error.places, (std::vector<Vec3>{points[31], points[800]}));
    const std::string message = error.what();
    for (const char* part :
         {"Points 31 at (", " and 800 at (", "There are 4 points", "Make such points equal"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
    points[700].y = points[30].y + 1.001e-11 * extent;
    EXPECT_EQ(error_of(points, extent).ids, (std::vector<std::int64_t>{31, 800}));
    points[800] = points[31];
    EXPECT_NEAR(find_sites(points, extent).closest / extent, 1.001e-11, 1e-15);
  }
}

TEST(InputSites, TheLimitItselfIsFarEnough) {
  const double extent = 0x1p40, least = kLeastSeparation * extent;
  EXPECT_EQ(find_sites(std::vector<Vec3>{{0, 0, 0}, {0, -least, 0}}, extent).closest, least);
  EXPECT_EQ(error_of({{0, 0, 0}, {0, std::nextafter(least, 0), 0}}, extent).code(), ErrorCode::kBadInput);
  EXPECT_EQ(error_of({{0, 0, 0}, {5e-324, 0, 0}}, 1).ids, (std::vector<std::int64_t>{0, 1}));
}

TEST(InputSites, RefusesCoordinatesThatAreNotFinite) {
  for (const double bad : {kInfinity, -kInfinity, std::nan("")}) {
    const Error error = error_of({{0, 0, 0}, {1, bad, 0}}, 1);
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.ids, std::vector<std::int64_t>{1});
    EXPECT_NE(std::string(error.what()).find("Point 1 at (1, "), std::string::npos) << error.what();
  }
}

TEST(InputSites, ManyPointsOnAPlaneOrALineTakeNoLonger) {
  std::vector<Vec3> plane, line;
  for (int i = 0; i < 50'000; ++i) {
    plane.push_back({0, double(i % 317), double(i / 317)});
    line.push_back({0, 0, double(i)});
  }
  EXPECT_EQ(find_sites(plane, 317).closest, 1);
  EXPECT_EQ(find_sites(line, 5e4).closest, 1);
}

/// The promise that the refinement relies on, for the hardest inputs that are accepted.
TEST(InputSites, SitesAreDistinctAndManyLatticeStepsApart) {
  Random random(4);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const double extent = std::ldexp(1.3, int(random.integer(-800, 800)));
    const double offset_ratio = std::ldexp(1.0, int(random.integer(-30, 14)));
    const Vec3 offset = (extent * offset_ratio) * random_place(random, 1);
    std::vector<Vec3> points = random_points(random, 50, 0.5 * extent);
    for (Vec3& p : points) p = p + offset;
    const double gap = extent * std::pow(10, -random.real(3, offset_ratio > 0.1 ? 6 : 10.99));
    points.push_back(points[7] + Vec3{0, gap, 0});
    points.push_back(points[7]);
    Box3 box;
    for (const Vec3& p : points) box.extend(p);
    const InputSites sites = find_sites(points, box.longest_side());
    const World world = World::fit(box, random.real(0.001, 0.1) * extent, sites.max_step());
    const double step = power_of_two(world.finest_level() / 2);
    EXPECT_LE(step * world.unit(), sites.max_step());
    const std::vector<Vec3> places = to_world(sites, points, world);
    ASSERT_EQ(places.size(), sites.first_point.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(places[i], world.to_world(points[sites.first_point[i]]));
      for (std::size_t j = 0; j < i; ++j) EXPECT_GT(dist(places[i], places[j]), 110 * step);
    }
  }
}

TEST(InputSites, PointsThatAreTooCloseForTheirOffsetAreRefusedWithAReason) {
  const Box3 box{{1e6, 0, 0}, {1e6 + 1, 1, 1}};
  const std::vector<Vec3> points{{1e6, 0, 0}, {1e6 + 1e-9, 0, 0}, {1e6 + 1, 1, 1}};
  const InputSites sites = find_sites(points, 1);
  EXPECT_NO_THROW((void)World::fit(box, 0.1));
  try {
    (void)World::fit(box, 0.1, sites.max_step());
    FAIL() << "a millionth of a millimetre, a kilometre away";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kLimit);
    EXPECT_NE(std::string(error.what()).find("so close together"), std::string::npos) << error.what();
  }
}

TEST(InputSites, AWorldThatIsNotTheirsIsRefused) {
  const auto code = [](const std::vector<Vec3>& points, const World& world) {
    try {
      (void)to_world(find_sites(points, 0), points, world);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  const World world{Frame{}};
  EXPECT_EQ(code({{0, 0, 0}, {0, 0, 2}}, world), ErrorCode::kBadInput);
  EXPECT_EQ(code({{0, 0, 0}, {0, 0, 2.5}}, world), ErrorCode::kInternal);
  EXPECT_EQ(code({{0, 0, 0}, {0, 0x1p48, 0}}, world), ErrorCode::kBadInput);
  EXPECT_EQ(code({{0, 0, 0}, {0, 0x1p48 - 1, 0}}, world), ErrorCode::kInternal);
}

}  // namespace
}  // namespace unsliver::lattice
