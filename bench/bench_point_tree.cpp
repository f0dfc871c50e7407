/// Time of the queries about input vertices that the refinement asks, on uniform and clustered points.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "geom/point_tree.hpp"

namespace unsliver::geom {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double real(double lo, double hi) { return lo + (hi - lo) * 0x1p-53 * double(bits_() >> 11); }
  std::size_t index(std::size_t size) { return bits_() % size; }
  /// Integers in the cube about the center.
  Vec3 near(const Vec3& center, double half) {
    const auto coordinate = [&](double c) { return std::floor(c + real(-half, half)); };
    const double x = coordinate(center.x), y = coordinate(center.y);
    return {x, y, coordinate(center.z)};
  }

 private:
  std::mt19937_64 bits_;
};

constexpr double kHalfWorld = 0x1p44;

std::vector<Vec3> uniform_points(std::size_t count) {
  Random random(1);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = random.near({0, 0, 0}, kHalfWorld);
  return points;
}

/// Clusters of 1,000 points whose sizes differ by 10^6.
std::vector<Vec3> clustered_points(std::size_t count) {
  Random random(1);
  std::vector<Vec3> points;
  while (points.size() < count) {
    const Vec3 center = random.near({0, 0, 0}, kHalfWorld / 2);
    const double size = 0x1p40 * std::pow(10, -random.real(0, 6));
    for (int i = 0; i < 1000; ++i) points.push_back(random.near(center, size));
  }
  return points;
}

struct Query {
  Vec3 center;
  double half;
};

/// Cubes near the points, on the scale of the spacing there; about 3 in 10 hold a point.
std::vector<Query> queries(const PointTree& tree, const std::vector<Vec3>& points) {
  Random random(2);
  std::vector<Query> result(1 << 16);
  for (Query& query : result) {
    const Vec3& near = points[random.index(points.size())];
    const double reach = std::sqrt(tree.two_nearest(near).second_sq) * std::pow(10, random.real(-1, 0.5));
    query.center = random.near(near, reach);
    query.half = std::floor(reach * std::pow(10, random.real(-1, 0.1)));
  }
  return result;
}

template <class Ask>
void run(benchmark::State& state, const Ask& ask) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Vec3> points = state.range(1) != 0 ? clustered_points(count) : uniform_points(count);
  const PointTree tree(points);
  const std::vector<Query> all = queries(tree, points);
  std::size_t i = 0, hits = 0;
  for (auto _ : state) {
    hits += ask(tree, all[i]) ? 1 : 0;
    i = (i + 1) % all.size();
  }
  state.counters["hits"] = double(hits) / double(state.iterations());
}

void first_in_cube(benchmark::State& state) {
  run(state, [](const PointTree& tree, const Query& q) {
    return tree.first_in_cube(q.center, q.half) != kNoVertex;
  });
}

void has_in_cube(benchmark::State& state) {
  run(state, [](const PointTree& tree, const Query& q) { return tree.has_in_cube(q.center, q.half); });
}

/// Radii like those of a certificate: many times the half side of the forbidden region.
void two_within(benchmark::State& state) {
  run(state, [](const PointTree& tree, const Query& q) { return tree.has_within(q.center, 15 * q.half, 2); });
}

void empty_ball(benchmark::State& state) {
  run(state, [](const PointTree& tree, const Query& q) { return tree.has_within(q.center, q.half, 1); });
}

void two_nearest(benchmark::State& state) {
  run(state, [](const PointTree& tree, const Query& q) {
    return std::isfinite(tree.two_nearest(q.center).second_sq);
  });
}

void build(benchmark::State& state) {
  const std::vector<Vec3> points = uniform_points(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(PointTree(points).size());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"points", "clustered"});
  for (const std::int64_t clustered : {0, 1})
    for (const std::int64_t count : {2'000, 100'000, 1'000'000}) benchmark->Args({count, clustered});
}

BENCHMARK(first_in_cube)->Apply(sizes);
BENCHMARK(has_in_cube)->Apply(sizes);
BENCHMARK(two_within)->Apply(sizes);
BENCHMARK(empty_ball)->Apply(sizes);
BENCHMARK(two_nearest)->Apply(sizes);
BENCHMARK(build)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace unsliver::geom
