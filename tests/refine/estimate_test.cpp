// Estimates against what is then made.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"

namespace unsliver {
namespace {

const Box3 kReadmeBox{{0, 0, 0}, {2, 1, 1}};
const Box3 kUnitBox{{0, 0, 0}, {1, 1, 1}};
const double kNoSize = 1e6;  // beyond the domain: nothing is demanded

std::vector<Vec3> random_points(std::size_t count, unsigned seed) {
  std::mt19937_64 bits(seed);
  const auto coordinate = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

MeshOptions bounds(double min_angle, double max_angle, double max_ratio,
                   Strategy strategy = Strategy::kAuto) {
  MeshOptions options;
  options.strategy = strategy;
  options.min_dihedral_deg = min_angle;
  options.max_dihedral_deg = max_angle;
  options.max_radius_edge = max_ratio;
  return options;
}

void expect_within(double factor, const SizeEstimate& estimate, const TetMesh& made) {
  const auto vertices = static_cast<double>(made.points.size()), tets = static_cast<double>(made.tets.size());
  EXPECT_LT(estimate.vertices, factor * vertices);
  EXPECT_GT(estimate.vertices, vertices / factor);
  EXPECT_LT(estimate.tets, factor * tets);
  EXPECT_GT(estimate.tets, tets / factor);
}

void expect_good(const Domain& domain, const Sizing& sizing, const std::vector<Vec3>& inputs,
                 const MeshOptions& options, double factor = 1.5) {
  expect_within(factor, estimate_size(domain, sizing, inputs, options),
                mesh_domain(domain, sizing, inputs, options).mesh);
}

TEST(Estimate, OfConstantSizes) {
  const std::vector<DomainPtr> domains = {make_box(kReadmeBox), make_ball({0, 0, 0}, 1)};
  for (const DomainPtr& domain : domains)
    for (const double s : {0.2, 0.1, 0.06})
      for (const Strategy strategy : {Strategy::kOctree, Strategy::kThrifty, Strategy::kLiteral}) {
        SCOPED_TRACE(domain->describe() + " " + std::to_string(s) + " " + to_string(strategy));
        MeshOptions options;
        options.strategy = strategy;
        expect_good(*domain, *constant_size(s), {}, options, strategy == Strategy::kLiteral ? 2 : 1.5);
      }
}

TEST(Estimate, OfVaryingSizes) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  for (const char* size : {"0.05 + 0.05 * (x + 1)", "0.05 + 0.3 * (x + 1)"})
    for (const Strategy strategy : {Strategy::kOctree, Strategy::kThrifty, Strategy::kLiteral}) {
      SCOPED_TRACE(std::string(size) + " " + to_string(strategy));
      MeshOptions options;
      options.strategy = strategy;
      expect_good(*ball, *expression_size(size, ball->bounds()), {}, options);
    }
}

TEST(Estimate, OfRandomPoints) {
  const DomainPtr box = make_box(kUnitBox);
  for (const auto& options : {bounds(30, 135, 1.368), bounds(20, 145, 1.368), bounds(15, 150, 1.5),
                              bounds(10, 155, 2), bounds(15, 150, 1.5, Strategy::kLiteral)}) {
    SCOPED_TRACE(std::to_string(options.min_dihedral_deg) + " " + to_string(options.strategy));
    expect_good(*box, *constant_size(kNoSize), random_points(1000, 1), options);
  }
}

TEST(Estimate, OfPointsAndASize) {
  const DomainPtr box = make_box(kUnitBox);
  for (const double s : {0.1, 0.05})
    for (const auto& options : {bounds(30, 135, 1.368), bounds(15, 150, 1.5)}) {
      SCOPED_TRACE(std::to_string(s) + " " + std::to_string(options.min_dihedral_deg));
      expect_good(*box, *constant_size(s), random_points(1000, 2), options);
    }
}

/// The facets of one tetrahedron each, seen from outside.
TriangleMesh boundary(const TetMesh& mesh) {
  std::map<std::array<VertexId, 3>, std::array<VertexId, 3>> once;
  for (const auto& [a, b, c, d] : mesh.tets)
    for (const std::array<VertexId, 3>& facet :
         {std::array{a, c, b}, std::array{a, b, d}, std::array{b, c, d}, std::array{a, d, c}}) {
      std::array<VertexId, 3> key = facet;
      std::sort(key.begin(), key.end());
      if (!once.emplace(key, facet).second) once.erase(key);
    }
  TriangleMesh surface{mesh.points, {}, "boundary"};
  for (const auto& [key, facet] : once) surface.triangles.push_back(facet);
  return surface;
}

// As `unsliver refine` has it.
TEST(Estimate, OfVerticesOfAGoodMesh) {
  const TetMesh mesh = mesh_domain(*make_ball({0, 0, 0}, 1), *constant_size(0.2)).mesh;
  expect_good(*make_surface(boundary(mesh)), *constant_size(kNoSize), mesh.points, bounds(30, 135, 1.368),
              1.05);
}

TEST(Estimate, OfLatticesShaken) {
  const DomainPtr box = make_box(kUnitBox);
  std::vector<Vec3> points;
  const std::vector<Vec3> shifts = random_points(1000, 3);
  for (const Vec3& shift : shifts) {
    const std::size_t i = points.size();
    points.push_back(1.0 / 9 * (Vec3{double(i % 10), double(i / 10 % 10), double(i / 100)} + 0.3 * shift));
  }
  for (const auto& options : {bounds(30, 135, 1.368), bounds(15, 150, 1.5)}) {
    SCOPED_TRACE(options.min_dihedral_deg);
    expect_good(*box, *constant_size(kNoSize), points, options, 2);
  }
}

TEST(Estimate, InfiniteSizesAndFewPoints) {
  const DomainPtr box = make_box(kUnitBox);
  for (const std::size_t count : {1, 2, 5}) {
    SCOPED_TRACE(count);
    const SizeEstimate estimate =
        estimate_size(*box, *constant_size(kNoSize), random_points(count, 4), MeshOptions{});
    EXPECT_GE(estimate.vertices, static_cast<double>(count));
    EXPECT_LT(estimate.vertices, 1000);
  }
}

TEST(Estimate, RefusesWhatTheGeneratorRefuses) {
  const DomainPtr box = make_box(kUnitBox);
  const std::vector<Vec3> close = {{0.5, 0.5, 0.5}, {0.5 + 1e-14, 0.5, 0.5}};
  EXPECT_THROW(estimate_size(*box, *constant_size(kNoSize), close, MeshOptions{}), Error);
}

}  // namespace
}  // namespace unsliver
