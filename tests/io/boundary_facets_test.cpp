#include <random>
#include <set>

#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

using Triangle = std::array<VertexId, 3>;

const std::vector<Vec3> kCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

/// `side`^3 cubes of six tetrahedra each, a random half of which is inverted.
TetMesh block(VertexId side, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  TetMesh mesh;
  const VertexId count = side + 1;
  for (VertexId i = 0; i < count * count * count; ++i)
    mesh.points.push_back({double(i % count), double(i / count % count), double(i / count / count)});
  const std::array<VertexId, 3> step{1, count, count * count};
  for (VertexId i = 0; i < count * count * count; ++i) {
    if (i % count == side || i / count % count == side || i / count / count == side) continue;
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
      std::array<VertexId, 4> tet{i, i + step[order[0]], 0, i + step[0] + step[1] + step[2]};
      tet[2] = tet[1] + step[order[1]];
      if (random() % 2 == 0) std::swap(tet[0], tet[1]);
      mesh.tets.push_back(tet);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return mesh;
}

double enclosed_volume(const TetMesh& mesh, const std::vector<Triangle>& triangles) {
  double volume = 0;
  for (const auto& [a, b, c] : triangles)
    volume += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6;
  return volume;
}

TEST(BoundaryFacets, OfOneTetrahedronLookOutward) {
  for (const std::array<VertexId, 4>& tet : {std::array<VertexId, 4>{0, 1, 2, 3}, {0, 2, 1, 3}}) {
    TetMesh mesh;
    mesh.points = kCorners;
    mesh.tets = {tet};
    const std::vector<Triangle> facets = boundary_facets(mesh);
    EXPECT_EQ(facets.size(), 4u);
    EXPECT_DOUBLE_EQ(enclosed_volume(mesh, facets), 1.0 / 6);
  }
}

TEST(BoundaryFacets, EncloseTheMesh) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const auto side = VertexId(1 + seed);
    const TetMesh mesh = block(side, seed);
    const std::vector<Triangle> facets = boundary_facets(mesh);
    EXPECT_EQ(facets.size(), 12u * side * side);
    EXPECT_NEAR(enclosed_volume(mesh, facets), double(side) * side * side, 1e-9);
    std::set<std::pair<VertexId, VertexId>> edges;
    for (const auto& [a, b, c] : facets) edges.insert({{a, b}, {b, c}, {c, a}});
    EXPECT_EQ(edges.size(), 3 * facets.size());  // each in one direction once
    for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a}));
  }
}

TEST(BoundaryFacets, AreTheFacesOfTetgenWhereAMeshHasNone) {
  TemporaryFolder folder;
  TetMesh mesh;
  mesh.points = kCorners;
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  write_tet_mesh(folder / "a.node", mesh);
  const TetMesh again = read_tet_mesh(folder / "a.node");
  EXPECT_EQ(again.triangles, boundary_facets(mesh));
  EXPECT_EQ(again.triangle_labels, std::vector<std::int32_t>(6, 1));
  mesh.triangles = {{1, 2, 3}};
  write_tet_mesh(folder / "b.node", mesh);
  EXPECT_EQ(read_tet_mesh(folder / "b.node").triangles, mesh.triangles);
}

}  // namespace
}  // namespace unsliver::io
