#include <algorithm>
#include <random>

#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

struct Case {
  const char* format;
  const char* file;
  bool ascii;
  bool keeps_points;  ///< has levels, point_source and frame
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.format << (c.ascii ? " ascii" : ""); }

class RoundTrip : public testing::TestWithParam<Case> {
 protected:
  TetMesh through_file(const TetMesh& mesh) const {
    const auto path = folder_ / GetParam().file;
    write_tet_mesh(path, mesh,
                   {.format = GetParam().format, .ascii = GetParam().ascii, .min_dihedral_deg = {}});
    return read_tet_mesh(path);
  }
  TemporaryFolder folder_;
};

void expect_same(const TetMesh& got, const TetMesh& expected) {
  expect_same_points(got.points, expected.points);
  EXPECT_EQ(got.tets, expected.tets);
  EXPECT_EQ(got.regions, expected.regions);
  EXPECT_EQ(got.triangles, expected.triangles);
  EXPECT_EQ(got.triangle_labels, expected.triangle_labels);
  EXPECT_EQ(got.levels, expected.levels);
  EXPECT_EQ(got.point_source, expected.point_source);
  ASSERT_EQ(got.frame.has_value(), expected.frame.has_value());
  if (!expected.frame) return;
  EXPECT_EQ(got.frame->unit, expected.frame->unit);
  EXPECT_EQ(got.frame->origin, expected.frame->origin);
}

// What is left of a mesh in the format: msh41 orders elements by label, tetgen knows no mesh without faces.
TetMesh as_kept(TetMesh mesh, const Case& c) {
  if (!c.keeps_points) {
    mesh.levels.clear();
    mesh.point_source.clear();
    mesh.frame.reset();
  }
  if (std::string(c.format) == "tetgen" && mesh.triangles.empty()) {
    mesh.triangles = boundary_facets(mesh);
    mesh.triangle_labels.assign(mesh.triangles.size(), 1);
  }
  if (std::string(c.format) != "msh41") return mesh;
  const auto sort_by_label = [](auto& elements, std::vector<std::int32_t>& labels) {
    if (labels.empty()) return;
    auto old_elements = elements;
    auto old_labels = labels;
    std::stable_sort(labels.begin(), labels.end());
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < labels.size(); ++i) next.push_back(i);
    std::stable_sort(next.begin(), next.end(),
                     [&](std::size_t a, std::size_t b) { return old_labels[a] < old_labels[b]; });
    for (std::size_t i = 0; i < next.size(); ++i) elements[i] = old_elements[next[i]];
  };
  sort_by_label(mesh.tets, mesh.regions);
  sort_by_label(mesh.triangles, mesh.triangle_labels);
  return mesh;
}

TEST_P(RoundTrip, KeepsEverythingTheFormatHolds) {
  const TetMesh mesh = sample_mesh();
  expect_same(through_file(mesh), as_kept(mesh, GetParam()));
}

TEST_P(RoundTrip, KeepsABareMeshBare) {
  TetMesh mesh;
  mesh.points = sample_mesh().points;
  mesh.tets = sample_mesh().tets;
  expect_same(through_file(mesh), as_kept(mesh, GetParam()));
}

TEST_P(RoundTrip, KeepsUnlabelledTriangles) {
  TetMesh mesh = sample_mesh();
  mesh.regions.clear();
  mesh.triangle_labels.clear();
  expect_same(through_file(mesh), as_kept(mesh, GetParam()));
}

TEST_P(RoundTrip, KeepsRandomMeshes) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    TetMesh mesh;
    const std::size_t n = 3000 + random() % 1000;
    while (mesh.points.size() < n) {
      const auto draw = [&] { return std::bit_cast<double>(random()); };
      const Vec3 p{draw(), draw(), draw()};
      if (is_finite(p)) mesh.points.push_back(p);
    }
    const auto vertex = [&] { return static_cast<VertexId>(random() % n); };
    for (int i = 0; i < 30000; ++i) {
      mesh.tets.push_back({vertex(), vertex(), vertex(), vertex()});
      mesh.regions.push_back(static_cast<std::int32_t>(random() % 5) + 1);
    }
    for (int i = 0; i < 500; ++i) mesh.triangles.push_back({vertex(), vertex(), vertex()});
    const TetMesh got = through_file(mesh);
    if (std::string(GetParam().format) == "vtu") {
      // One array holds the labels of tetrahedra and triangles: the latter become 0.
      mesh.triangle_labels.assign(mesh.triangles.size(), 0);
    }
    expect_same(got, as_kept(mesh, GetParam()));
  }
}

TEST_P(RoundTrip, WritesTheSameBytesTwice) {
  const WriteOptions options{.format = GetParam().format, .ascii = GetParam().ascii, .min_dihedral_deg = {}};
  write_tet_mesh(folder_ / GetParam().file, sample_mesh(), options);
  const std::string first = get_file(folder_ / GetParam().file);
  write_tet_mesh(folder_ / GetParam().file, sample_mesh(), options);
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(get_file(folder_ / GetParam().file), first);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, RoundTrip,
    testing::Values(Case{"vtu", "a.vtu", false, true}, Case{"msh22", "a.msh", false, false},
                    Case{"msh22", "a.msh", true, false}, Case{"msh41", "a.msh", false, false},
                    Case{"msh41", "a.msh", true, false}, Case{"medit", "a.mesh", false, false},
                    Case{"tetgen", "a.node", false, false}, Case{"tetgen", "a.1.ele", false, false}));

}  // namespace
}  // namespace unsliver::io
