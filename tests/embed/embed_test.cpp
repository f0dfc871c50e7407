#include "unsliver/embed.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "unsliver/error.hpp"

namespace unsliver {
namespace {

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// n^3 unit cubes, each cut into six tetrahedra along its diagonal.
TetMesh cubes(VertexId n) {
  TetMesh mesh;
  const auto id = [n](VertexId x, VertexId y, VertexId z) { return (z * (n + 1) + y) * (n + 1) + x; };
  for (VertexId z = 0; z <= n; ++z)
    for (VertexId y = 0; y <= n; ++y)
      for (VertexId x = 0; x <= n; ++x) mesh.points.push_back({double(x), double(y), double(z)});
  for (VertexId z = 0; z < n; ++z)
    for (VertexId y = 0; y < n; ++y)
      for (VertexId x = 0; x < n; ++x) {
        std::array<int, 3> axes = {0, 1, 2};
        do {
          std::array<VertexId, 3> at = {x, y, z};
          std::array<VertexId, 4> tet = {id(x, y, z)};
          for (std::size_t i = 0; i < 3; ++i) {
            ++at[static_cast<std::size_t>(axes[i])];
            tet[i + 1] = id(at[0], at[1], at[2]);
          }
          mesh.tets.push_back(tet);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return mesh;
}

Vec3 place(const TetMesh& mesh, const Embedding& embedding, std::size_t i) {
  Vec3 sum;
  for (std::size_t k = 0; k < 4; ++k)
    sum = sum + embedding.weights[i][k] * mesh.points[static_cast<std::size_t>(embedding.vertices[i][k])];
  return sum;
}

TEST(Embed, FindsPlacesAgain) {
  const TetMesh mesh = cubes(5);
  std::mt19937_64 random(1);
  std::vector<Vec3> points = mesh.points;  // on vertices, edges and facets too
  for (int i = 0; i < 3000; ++i)
    points.push_back({5 * uniform(random), 5 * uniform(random), 5 * uniform(random)});
  for (int i = 0; i < 300; ++i) points.push_back({5, std::floor(5 * uniform(random)), 5 * uniform(random)});
  const Embedding embedding = embed_points(mesh, points);
  ASSERT_EQ(embedding.tets.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LT(dist(place(mesh, embedding, i), points[i]), 1e-14);
    const auto& corners = mesh.tets[static_cast<std::size_t>(embedding.tets[i])];
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_EQ(embedding.vertices[i][k], corners[k]);
      ASSERT_GE(embedding.weights[i][k], 0);
    }
    ASSERT_NEAR(std::accumulate(embedding.weights[i].begin(), embedding.weights[i].end(), 0.0), 1, 1e-15);
  }
}

TEST(Embed, TakesTheFirstOfTetrahedraThatServeEqually) {
  const TetMesh mesh = cubes(1);
  const std::vector<Vec3> points = {{0, 0, 0}, {0.5, 0.5, 0.5}};
  EXPECT_EQ(embed_points(mesh, points).tets, (std::vector<std::int64_t>{0, 0}));
}

TEST(Embed, ForgivesRoundingAndNoMore) {
  const TetMesh mesh = cubes(2);
  const Vec3 just_outside{2 + 4e-16, 1.3, 0.4};
  const Embedding embedding = embed_points(mesh, {&just_outside, 1});
  for (const double w : embedding.weights[0]) EXPECT_GE(w, 0);
  EXPECT_LT(dist(place(mesh, embedding, 0), just_outside), 1e-14);
  const std::vector<Vec3> points = {{1, 1, 1}, {2.001, 1, 1}, {0.5, 0.5, 0.5}, {-7, 0, 0}};
  try {
    embed_points(mesh, points);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadInput);
    EXPECT_EQ(error.ids, (std::vector<std::int64_t>{1, 3}));
    ASSERT_EQ(error.places.size(), 2u);
    EXPECT_EQ(error.places[1], points[3]);
  }
}

TEST(Embed, FlatAndInvertedTetrahedra) {
  TetMesh mesh = cubes(1);
  mesh.tets.insert(mesh.tets.begin(), {0, 1, 2, 3});  // flat: the lower face's corners
  for (auto& tet : mesh.tets) std::swap(tet[0], tet[1]);
  const Vec3 p{0.25, 0.5, 0};
  const Embedding embedding = embed_points(mesh, {&p, 1});
  EXPECT_NE(embedding.tets[0], 0);
  EXPECT_LT(dist(place(mesh, embedding, 0), p), 1e-15);
}

TEST(Embed, NoTetrahedraNoPoints) {
  EXPECT_TRUE(embed_points({}, {}).tets.empty());
  const Vec3 p;
  EXPECT_THROW(embed_points({}, {&p, 1}), Error);
}

}  // namespace
}  // namespace unsliver
