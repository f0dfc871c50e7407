/// Input vertices among the tetrahedra of octrees: the time of both as a multiple of what the octrees take
/// without them and Figure 8 takes on them alone, the best of some runs each.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <random>

#include "unsliver/refine.hpp"

namespace unsliver {
namespace {

std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto unit = [&] { return 0.02 + 0.96 * static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    const double x = unit(), y = unit(), z = unit();
    p = {x, y, z};
  }
  return points;
}

/// Seconds of processor time of one call: others may be using the machine.
template <class Work>
double seconds_of(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The cube with 10^7 tetrahedra, one thread: s constant, or graded about one point.
void guests(benchmark::State& state) {
  const DomainPtr box = make_box({{0, 0, 0}, {1, 1, 1}});
  const bool graded = state.range(1) != 0;
  const SizingPtr size =
      graded ? graded_from_points({{0.5, 0.4, 0.3}}, {0.0023}, 0.015, 1) : constant_size(0.006);
  const SizingPtr none = constant_size(1e100);
  const std::vector<Vec3> points = random_points(static_cast<std::size_t>(state.range(0)), 1);
  MeshOptions octree, thrifty;
  octree.strategy = Strategy::kOctree;
  octree.threads = 1;
  thrifty.strategy = Strategy::kThrifty;
  double bulk = 1e9, alone = 1e9, both = 1e9;
  MeshResult made;
  for (auto _ : state) {
    made = {};
    bulk = std::min(bulk, seconds_of([&] { mesh_domain(*box, *size, octree); }));
    alone = std::min(alone, seconds_of([&] { mesh_domain(*box, *none, points, thrifty); }));
    both = std::min(both, seconds_of([&] { made = mesh_domain(*box, *size, points, octree); }));
  }
  state.SetLabel(fmt::format("{} points, s {}", points.size(), graded ? "graded" : "constant"));
  state.counters["tets"] = double(made.mesh.tets.size());
  state.counters["bulk_s"] = bulk;
  state.counters["figure_8_s"] = alone;
  state.counters["both_s"] = both;
  state.counters["ratio"] = both / (bulk + alone);
}

BENCHMARK(guests)->ArgsProduct({{100, 1000, 10000}, {0, 1}})->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace unsliver
