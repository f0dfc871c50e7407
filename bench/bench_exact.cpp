/// Time of one predicate, stage by stage; each prints which stages decided.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "exact/predicates.hpp"
#include "exact/quality_signs.hpp"

namespace unsliver::exact {
namespace {

using Five = std::array<Vec3, 5>;
constexpr std::size_t kSamples = 1024;

void report(benchmark::State& state, const StageCounts& counts) {
  const auto calls = static_cast<double>(counts.filter + counts.small + counts.wide);
  state.counters["filter"] = static_cast<double>(counts.filter) / calls;
  state.counters["small"] = static_cast<double>(counts.small) / calls;
  state.counters["wide"] = static_cast<double>(counts.wide) / calls;
  state.counters["tie"] = static_cast<double>(counts.tie) / calls;
}

template <class Point>
std::vector<Five> samples(Point point) {
  std::mt19937_64 random(1);
  std::vector<Five> result;
  StageCounts counts;
  while (result.size() < kSamples) {
    Five p;
    for (Vec3& q : p) q = point(random);
    const int sign = orient3d(p[0], p[1], p[2], p[3], counts);
    if (sign == 0 || p[4] == p[0] || p[4] == p[1] || p[4] == p[2] || p[4] == p[3]) continue;
    if (sign < 0) std::swap(p[0], p[1]);
    result.push_back(p);
  }
  return result;
}

std::vector<Five> random_points() {
  return samples([](std::mt19937_64& r) {
    return Vec3{double(r() >> 24), double(r() >> 24), double(r() >> 24)};
  });
}

/// Corners of one cube: the lattice's ties. 1: exact in doubles; 2^18 - 1: 128 bits; 2^40 - 1: 256 bits.
std::vector<Five> cube_corners(double side) {
  return samples([side](std::mt19937_64& r) {
    const std::uint64_t bits = r();
    return Vec3{side * double(bits & 1), side * double(bits >> 1 & 1), side * double(bits >> 2 & 1)};
  });
}

void run_insphere(benchmark::State& state, const std::vector<Five>& points) {
  StageCounts counts;
  std::size_t i = 0;
  for (auto _ : state) {
    const Five& p = points[i++ % kSamples];
    benchmark::DoNotOptimize(insphere_perturbed(p[0], p[1], p[2], p[3], p[4], counts));
  }
  report(state, counts);
}

void insphere_random(benchmark::State& state) { run_insphere(state, random_points()); }
void insphere_cube_corners(benchmark::State& state) {
  run_insphere(state, cube_corners(std::ldexp(1.0, static_cast<int>(state.range(0))) - 1));
}
BENCHMARK(insphere_random);
BENCHMARK(insphere_cube_corners)->Arg(1)->Arg(18)->Arg(40);

void run_orient(benchmark::State& state, std::vector<Five> points, bool flatten) {
  if (flatten)
    for (Five& p : points)
      for (Vec3& q : p) q.z = q.x + q.y;
  StageCounts counts;
  std::size_t i = 0;
  for (auto _ : state) {
    const Five& p = points[i++ % kSamples];
    benchmark::DoNotOptimize(orient3d(p[0], p[1], p[2], p[3], counts));
  }
  report(state, counts);
}

void orient_random(benchmark::State& state) { run_orient(state, random_points(), false); }
void orient_coplanar(benchmark::State& state) {
  run_orient(state, cube_corners(std::ldexp(1.0, static_cast<int>(state.range(0))) - 1), true);
}
BENCHMARK(orient_random);
BENCHMARK(orient_coplanar)->Arg(1)->Arg(40)->Arg(46);

void run_quality(benchmark::State& state, const std::vector<Tet>& tets, const QualityBounds& bounds) {
  StageCounts counts;
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(is_bad(tets[i++ % tets.size()], bounds, counts));
  report(state, counts);
}

/// Nearly regular tetrahedra: good, and nowhere near a bound.
void quality_good(benchmark::State& state) {
  std::mt19937_64 random(1);
  std::vector<Tet> tets(kSamples, Tet{Vec3{1, 1, 1}, Vec3{-1, 1, -1}, Vec3{1, -1, -1}, Vec3{-1, -1, 1}});
  for (Tet& t : tets)
    for (Vec3& p : t)
      p = 0x1p38 * p + Vec3{double(random() >> 30), double(random() >> 30), double(random() >> 30)};
  run_quality(state, tets, {});
}

/// A body-centred lattice's tetrahedron against its own angles and ratio.
void quality_at_bound(benchmark::State& state) {
  const double s = std::ldexp(1.0, static_cast<int>(state.range(0))) - 1;
  const Tet t = {Vec3{0, 0, 0}, Vec3{2 * s, 0, 0}, Vec3{s, s, s}, Vec3{s, s, -s}};
  run_quality(state, {t}, {{1, 1, 4}, {0, 0, 1}, {5, 12}});
}
BENCHMARK(quality_good);
BENCHMARK(quality_at_bound)->Arg(1)->Arg(12)->Arg(40);

}  // namespace
}  // namespace unsliver::exact
