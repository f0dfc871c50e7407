/// Vertices of each strategy where the size varies, as a multiple of what the thinnest covering would take:
/// the table of docs/CLOSURE.md. Time is measured too.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>

#include "unsliver/refine.hpp"

namespace unsliver {
namespace {

/// s = least + gradation * | |p - centre| - 0.3 |, in a box of side 0.75.
struct Field {
  double least, gradation;
};
constexpr std::array kFields = {Field{0.02, 0},    Field{0.015, 0.05}, Field{0.01, 0.1},
                                Field{0.006, 0.2}, Field{0.004, 0.3},  Field{0.0025, 0.5}};
constexpr std::array kStrategies = {Strategy::kOctree, Strategy::kClosure, Strategy::kThrifty,
                                    Strategy::kLiteral};
constexpr double kSide = 0.75;

SizingPtr size_of(const Field& field, const Box3& box) {
  if (field.gradation == 0) return constant_size(field.least);
  return expression_size(
      fmt::format("{} + {} * abs(sqrt((x - 0.375)^2 + (y - 0.375)^2 + (z - 0.375)^2) - 0.3)", field.least,
                  field.gradation),
      box);
}

/// Vertices in the box, its upper faces left out: they are another box's.
double vertices_in(const TetMesh& mesh) {
  double count = 0;
  for (const Vec3& p : mesh.points)
    count += p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < kSide && p.y < kSide && p.z < kSide;
  return count;
}

void economy(benchmark::State& state) {
  const Field& field = kFields[std::size_t(state.range(0))];
  const Box3 bounds{{0, 0, 0}, {kSide, kSide, kSide}};
  const DomainPtr box = make_box(bounds);
  const SizingPtr size = size_of(field, bounds);
  MeshOptions options;
  options.strategy = kStrategies[std::size_t(state.range(1))];
  options.threads = 1;
  MeshResult result;
  for (auto _ : state) result = mesh_domain(*box, *size, options);
  const double ideal = estimate_size(*box, *size, options).ideal_vertices, count = vertices_in(result.mesh);
  state.SetLabel(
      fmt::format("s >= {}, gradation {}, {}", field.least, field.gradation, to_string(options.strategy)));
  state.counters["ideal"] = ideal;
  state.counters["vertices/ideal"] = count / ideal;
  state.counters["tets/s"] =
      benchmark::Counter(double(result.mesh.tets.size()), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(economy)
    ->ArgsProduct({benchmark::CreateDenseRange(0, 5, 1), benchmark::CreateDenseRange(0, 3, 1)})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace unsliver
