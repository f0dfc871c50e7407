#include <limits>

#include "sizing/background_mesh.hpp"
#include "sizing_properties.hpp"

namespace unsliver {
namespace {

using namespace test;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// [0, 1]^3 in n^3 cubes of six tetrahedra each (Kuhn), without the cubes that `skip` names.
template <class Skip>
TetMesh kuhn_mesh(VertexId n, Skip skip) {
  TetMesh m;
  const VertexId row = n + 1, layer = row * row;
  const double h = 1.0 / n;
  for (VertexId k = 0; k <= n; ++k)
    for (VertexId j = 0; j <= n; ++j)
      for (VertexId i = 0; i <= n; ++i) m.points.push_back({i * h, j * h, k * h});
  const std::array<VertexId, 3> steps{1, row, layer};
  for (VertexId k = 0; k < n; ++k)
    for (VertexId j = 0; j < n; ++j)
      for (VertexId i = 0; i < n; ++i) {
        if (skip(i, j, k)) continue;
        const VertexId a = i + j * row + k * layer, d = a + 1 + row + layer;
        for (const auto& [u, v] : {std::pair{0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}}) {
          m.tets.push_back({a, a + steps[u], a + steps[u] + steps[v], d});
        }
      }
  return m;
}

TetMesh cube_mesh(VertexId n) {
  return kuhn_mesh(n, [](VertexId, VertexId, VertexId) { return false; });
}

/// Interior points moved at random, so that no face is special.
void shake(TetMesh& m, double by, Random& random) {
  for (Vec3& p : m.points) {
    const bool is_inner = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1 && p.z > 0 && p.z < 1;
    if (is_inner) p = p + Vec3{random.uniform(-by, by), random.uniform(-by, by), random.uniform(-by, by)};
  }
}

NodalField random_field(TetMesh mesh, Random& random) {
  NodalField f{std::move(mesh), {}};
  for (std::size_t i = 0; i < f.mesh.points.size(); ++i) f.values.push_back(random.uniform(0.05, 0.5));
  return f;
}

const Box3 kUnit{{0, 0, 0}, {1, 1, 1}};
const Box3 kAround{{-0.5, -0.5, -0.5}, {1.5, 1.5, 1.5}};

TEST(BackgroundSize, ReproducesLinearFunctionsAndTheirProjection) {
  Random random(1);
  NodalField f{cube_mesh(4), {}};
  shake(f.mesh, 0.05, random);
  const auto linear = [](const Vec3& p) { return 1 + 0.5 * p.x - 0.25 * p.y + 0.125 * p.z; };
  for (const Vec3& p : f.mesh.points) f.values.push_back(linear(p));
  const SizingPtr s = background_size(f);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = random.in(kAround);
    const Vec3 q{std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0), std::clamp(p.z, 0.0, 1.0)};
    ASSERT_NEAR(s->at(p), linear(q), 1e-12);
  }
  EXPECT_NEAR(s->lipschitz(), std::sqrt(0.25 + 0.0625 + 0.015625), 1e-7);
  for (std::size_t i = 0; i < f.mesh.points.size(); ++i)
    EXPECT_NEAR(s->at(f.mesh.points[i]), f.values[i], 1e-12);
}

TEST(BackgroundSize, IsSoundAndTightForRandomFields) {
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    Random random(seed);
    NodalField f = random_field(cube_mesh(4), random);
    shake(f.mesh, 0.05, random);
    const SizingPtr s = background_size(f);
    EXPECT_LT(s->lipschitz(), kInf);
    expect_sound(*s, kAround, 700);
    expect_tight(*s, {{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}}, 2 * s->lipschitz(), 1e-7);
    expect_tight(*s, {{-3, -3, -3}, {4, 4, 4}}, 2 * s->lipschitz(), 1e-6);
  }
}

TEST(BackgroundSize, InvertedTetrahedraServeAsWell) {
  Random random(4);
  NodalField f = random_field(cube_mesh(3), random);
  const SizingPtr s = background_size(f);
  for (auto& t : f.mesh.tets) std::swap(t[0], t[1]);
  const SizingPtr inverted = background_size(f);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.in(kAround);
    ASSERT_NEAR(s->at(p), inverted->at(p), 1e-12);
  }
}

TEST(BackgroundSize, FlatTetrahedraAreIgnored) {
  Random random(5);
  NodalField f = random_field(cube_mesh(2), random);
  const SizingPtr s = background_size(f);
  f.mesh.tets.push_back({0, 1, 2, 0});
  f.mesh.tets.push_back({0, 1, 2, 4});
  const SizingPtr with_flat = background_size(f);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.in(kUnit);
    ASSERT_NEAR(s->at(p), with_flat->at(p), 1e-12);
  }
}

TEST(BackgroundSize, NonConvexMeshesClaimNoLipschitzConstant) {
  Random random(6);
  const auto notch = [](VertexId i, VertexId j, VertexId) { return i >= 1 && i <= 2 && j >= 2; };
  const SizingPtr s = background_size(random_field(kuhn_mesh(4, notch), random));
  EXPECT_EQ(s->lipschitz(), kInf);
  EXPECT_EQ(s->notes().size(), 2u);
  expect_sound(*s, kAround, 1000);
}

TEST(BackgroundSize, DoubledTetrahedraAreRefused) {
  Random random(8);
  NodalField f = random_field(cube_mesh(1), random);
  f.mesh.tets.insert(f.mesh.tets.end(), f.mesh.tets.begin(), f.mesh.tets.end());
  expect_error([&] { background_size(f); }, ErrorCode::kBadInput, "more than once");
}

TEST(BackgroundMesh, TellsConvexFromOther) {
  const auto is_convex = [](const TetMesh& m) {
    return sizing::is_convex({m.points, boundary_facets(m), {}});
  };
  EXPECT_TRUE(is_convex(cube_mesh(1)));
  EXPECT_TRUE(is_convex(cube_mesh(3)));
  EXPECT_FALSE(is_convex(kuhn_mesh(2, [](VertexId i, VertexId j, VertexId k) { return i + j + k == 0; })));
  EXPECT_FALSE(is_convex(kuhn_mesh(3, [](VertexId i, VertexId, VertexId) { return i == 1; }))) << "two slabs";
  EXPECT_FALSE(is_convex(kuhn_mesh(3, [](VertexId i, VertexId j, VertexId k) {
    return i == 1 && j == 1 && k == 1;
  }))) << "a hole inside";
  EXPECT_EQ(boundary_facets(cube_mesh(3)).size(), 6u * 9 * 2);
}

TEST(BackgroundSize, NamesTheBadVertex) {
  Random random(7);
  const NodalField good = random_field(cube_mesh(2), random);
  for (double bad : {0.0, -1.0, kNan, kInf}) {
    NodalField f = good;
    f.values[13] = bad;
    const Error e =
        expect_error([&] { background_size(f); }, ErrorCode::kBadInput, "vertex 13 at (0.5, 0.5, 0.5)");
    EXPECT_EQ(e.ids, std::vector<std::int64_t>{13});
    EXPECT_EQ(e.places.size(), 1u);
  }
  NodalField f = good;
  f.mesh.points[3].z = kNan;
  expect_error([&] { background_size(f); }, ErrorCode::kBadInput, "vertex 3");
  f = good;
  f.mesh.tets[5][2] = 27;
  expect_error([&] { background_size(f); }, ErrorCode::kBadInput,
               "Tetrahedron 5 of the background mesh names vertex 27");
  f = good;
  f.values.pop_back();
  expect_error([&] { background_size(f); }, ErrorCode::kBadInput, "27 points but 26 sizes");
  f = good;
  f.mesh.tets.clear();
  expect_error([&] { background_size(f); }, ErrorCode::kBadInput, "no tetrahedra");
}

}  // namespace
}  // namespace unsliver
