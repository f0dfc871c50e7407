/// Octree meshes end to end, without output: tetrahedra a second and bytes a tetrahedron, with one thread and
/// two.
///
/// Aim: one core, 2.5e7 tetrahedra, 2e7 a second and 26 bytes each, constant and graded; two cores 1.8 times
/// as fast. "CPU" is that of all threads.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "octree/octree.hpp"

namespace unsliver {
namespace {

/// Integral of 1 / (2.862 s^3) over a domain in the box from -1 to 1: the thinnest covering there is.
double ideal_vertices(const Domain& domain, const Sizing& size) {
  constexpr int kCells = 100;
  double sum = 0;
  for (int i = 0; i < kCells * kCells * kCells; ++i) {
    const auto at = [](int n) { return (2.0 * n + 1) / kCells - 1; };
    const Vec3 p{at(i % kCells), at(i / kCells % kCells), at(i / kCells / kCells)};
    if (domain.contains(p)) sum += std::pow(size.at(p), -3);
  }
  return sum * std::pow(2.0 / kCells, 3) / 2.862;
}

/// `make(options)` gives the mesh.
template <class Make>
void measure(benchmark::State& state, const Domain& domain, const Sizing& size, const Make& make) {
  octree::OctreeOptions options;
  options.threads = unsigned(state.range(0));
  octree::OctreeResult result;
  for (auto _ : state) {
    result = {};
    result = make(options);
  }
  const auto tets = double(result.mesh.tets.size());
  double inside = 0;
  for (const Vec3& p : result.mesh.points) inside += domain.contains(p);
  state.counters["tets"] = tets;
  state.counters["tets/s"] = benchmark::Counter(tets, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes/tet"] = double(result.stats.peak_bytes) / tets;
  state.counters["inside/ideal"] = inside / ideal_vertices(domain, size);
  for (const auto& phase : result.stats.phases) state.counters[phase.name + " ms"] = 1e3 * phase.seconds;
}

void mesh_ball(benchmark::State& state, const SizingPtr& size) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  measure(state, *ball, *size, [&](const octree::OctreeOptions& options) {
    return octree::mesh_domain_octree(*ball, *size, options);
  });
}

/// Filled exactly, its faces marked.
void mesh_box(benchmark::State& state, const SizingPtr& size) {
  const DomainPtr box = make_box({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  measure(state, *box, *size, [&](const octree::OctreeOptions& options) {
    return octree::mesh_box_octree(box->bounds(), *size, options);
  });
}

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void constant(benchmark::State& state) { mesh_ball(state, constant_size(0.0071)); }
void gradation_10(benchmark::State& state) {
  mesh_ball(state, graded_from_points({{0.1, 0.2, 0.3}}, {0.00081}, 0.1, 0.00745));
}
void gradation_30(benchmark::State& state) {
  mesh_ball(state, graded_from_points({{0.1, 0.2, 0.3}}, {0.00018}, 0.3, 0.0071));
}
/// No part of constant size.
void gradation_2(benchmark::State& state) {
  mesh_ball(state, graded_from_points({{0.1, 0.2, 0.3}}, {0.00078}, 0.0163, kInfinite));
}
/// Many sources: most of the time goes to the sizing function.
void gradation_20_many(benchmark::State& state) {
  std::vector<Vec3> points;
  for (int i = 0; i < 64; ++i)
    points.push_back({std::cos(0.7 * i) * 0.8, std::sin(0.7 * i) * 0.8, 0.02 * i - 0.6});
  mesh_ball(state, graded_from_points(points, {0.0005}, 0.2, kInfinite));
}

void box_constant(benchmark::State& state) { mesh_box(state, constant_size(0.00438)); }
void box_gradation_1(benchmark::State& state) {
  mesh_box(state, graded_from_points({{0.1, 0.2, 0.3}}, {0.00078}, 0.0137, kInfinite));
}

/// The first mesh is not counted: its memory may be the system's first.
void once_warm(benchmark::internal::Benchmark* b) {
  b->Arg(1)
      ->Arg(2)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime()
      ->MinWarmUpTime(0.1);
}

BENCHMARK(constant)->Apply(once_warm);
BENCHMARK(gradation_2)->Apply(once_warm);
BENCHMARK(gradation_10)->Apply(once_warm);
BENCHMARK(gradation_30)->Apply(once_warm);
BENCHMARK(gradation_20_many)->Apply(once_warm);
BENCHMARK(box_constant)->Apply(once_warm);
BENCHMARK(box_gradation_1)->Apply(once_warm);

}  // namespace
}  // namespace unsliver
