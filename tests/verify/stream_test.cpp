// The streaming judge on a mesh made by hand: it accepts what is right and finds each fault planted.
#include <gtest/gtest.h>

#include <limits>

#include "unsliver/verify_stream.hpp"

namespace unsliver {
namespace {

/// Level of an odd point of a BCC lattice with cells of side 2, and of an even one.
constexpr std::uint8_t kCenter = 2, kCorner = 3;

class Arrays : public MeshSource {
 public:
  MeshHead head() const override { return {mesh.points.size(), mesh.tets.size(), *mesh.frame}; }
  void read_points(std::uint64_t first, std::span<Vec3> points, std::span<std::uint8_t> levels) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = mesh.points.at(first + i);
      levels[i] = mesh.levels.at(first + i);
    }
  }
  void read_tets(std::uint64_t first, std::span<std::array<VertexId, 4>> tets) override {
    for (std::size_t i = 0; i < tets.size(); ++i) tets[i] = mesh.tets.at(first + i);
  }

  TetMesh mesh;
};

/// The BCC tetrahedra about the interior faces of n^3 cells.
Arrays lattice_mesh(int n) {
  Arrays arrays;
  TetMesh& mesh = arrays.mesh;
  mesh.frame = Frame{1, {0, 0, 0}};
  const auto corner = [&](int x, int y, int z) { return VertexId(x + (n + 1) * (y + (n + 1) * z)); };
  const auto center = [&](int x, int y, int z) {
    return VertexId((n + 1) * (n + 1) * (n + 1) + x + n * (y + n * z));
  };
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) mesh.points.push_back({2.0 * x, 2.0 * y, 2.0 * z});
  mesh.levels.assign(mesh.points.size(), kCorner);
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) mesh.points.push_back({2.0 * x + 1, 2.0 * y + 1, 2.0 * z + 1});
  mesh.levels.resize(mesh.points.size(), kCenter);
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const int step[3] = {axis == 0, axis == 1, axis == 2};
          if (x + step[0] == n || y + step[1] == n || z + step[2] == n) continue;
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          VertexId ring[4];
          for (int i = 0; i < 4; ++i) {
            int at[3] = {x + step[0], y + step[1], z + step[2]};
            at[u] += i == 1 || i == 2;
            at[v] += i == 2 || i == 3;
            ring[i] = corner(at[0], at[1], at[2]);
          }
          const VertexId a = center(x, y, z), b = center(x + step[0], y + step[1], z + step[2]);
          for (int i = 0; i < 4; ++i) mesh.tets.push_back({a, b, ring[i], ring[(i + 1) % 4]});
        }
  return arrays;
}

StreamVerifyReport judge(Arrays& arrays) {
  StreamVerifyOptions options;
  options.guarantee = QualityGuarantee{};
  options.inside = [](const Vec3& p) {
    return std::min({p.x, p.y, p.z}) >= 1 && std::max({p.x, p.y, p.z}) <= 9;
  };
  return verify_stream(arrays, options);
}

bool found(const VerifyReport& report, const std::string& check) {
  return std::any_of(report.findings.begin(), report.findings.end(),
                     [&](const Finding& finding) { return finding.check == check; });
}

TEST(VerifyStream, AgreesWithTheJudgeOfArrays) {
  Arrays arrays = lattice_mesh(5);
  const StreamVerifyReport streamed = judge(arrays);
  EXPECT_EQ(streamed.checks.size(), 8u);
  EXPECT_EQ(streamed.bounds.lo, (Vec3{0, 0, 0}));
  EXPECT_EQ(streamed.bounds.hi, (Vec3{10, 10, 10}));
  std::uint64_t tets = 0;
  for (const TetShape& shape : streamed.shapes) tets += shape.tets;
  EXPECT_EQ(tets, arrays.mesh.tets.size());
  EXPECT_EQ(streamed.shapes.size(), 12u);
  VerifyOptions options;
  options.guarantee = QualityGuarantee{};
  const VerifyReport whole = verify(arrays.mesh, options);
  for (const Finding& f : streamed.findings) ADD_FAILURE() << f.message;
  EXPECT_TRUE(streamed.ok && whole.ok);
  EXPECT_DOUBLE_EQ(streamed.min_dihedral_deg, whole.min_dihedral_deg);
  EXPECT_DOUBLE_EQ(streamed.max_dihedral_deg, whole.max_dihedral_deg);
  EXPECT_DOUBLE_EQ(streamed.max_radius_edge, whole.max_radius_edge);
  EXPECT_DOUBLE_EQ(streamed.volume, whole.volume);
  EXPECT_DOUBLE_EQ(streamed.volume, 3 * 4 * 5 * 5 * 4 * (8.0 / 12));
}

/// More tetrahedra and vertices than are read at once.
TEST(VerifyStream, ReadsInChunks) {
  Arrays arrays = lattice_mesh(42);
  EXPECT_GT(arrays.mesh.tets.size(), 8u << 16);
  EXPECT_GT(arrays.mesh.points.size(), 2u << 16);
  const VerifyReport report = judge(arrays);
  EXPECT_TRUE(report.ok);
  for (const Finding& f : report.findings) ADD_FAILURE() << f.message;
  std::swap(arrays.mesh.tets[500000][0], arrays.mesh.tets[500000][1]);
  EXPECT_TRUE(found(judge(arrays), "orientation"));
  EXPECT_EQ(judge(arrays).findings[0].ids[0], 500000);
}

struct Fault {
  const char* name;
  const char* check;
  void (*plant)(TetMesh&);
};

const Fault kFaults[] = {
    {"two corners swapped", "orientation", [](TetMesh& m) { std::swap(m.tets[7][1], m.tets[7][2]); }},
    {"flat", "orientation",
     [](TetMesh& m) {
       m.tets[7] = {0, 1, 2, 3};
     }},
    {"another vertex", "cover", [](TetMesh& m) { m.tets[500][0] = m.tets[520][0]; }},
    {"a tetrahedron missing", "cover", [](TetMesh& m) { m.tets.erase(m.tets.begin() + 500); }},
    {"a tetrahedron twice", "conformity", [](TetMesh& m) { m.tets[7] = m.tets[8]; }},
    {"two tetrahedra twice", "conformity",
     [](TetMesh& m) {
       m.tets.push_back(m.tets[7]);
       m.tets.push_back(m.tets[8]);
     }},
    {"all twice", "conformity",
     [](TetMesh& m) {
       const auto copy = m.tets;
       m.tets.insert(m.tets.end(), copy.begin(), copy.end());
     }},
    {"index out of range", "index", [](TetMesh& m) { m.tets[7][3] = VertexId(m.points.size()); }},
    {"largest index", "index", [](TetMesh& m) { m.tets[7][3] = kNoVertex; }},
    {"a vertex twice in one", "index", [](TetMesh& m) { m.tets[7][3] = m.tets[7][0]; }},
    {"a point off the grid", "lattice", [](TetMesh& m) { m.points[100].x += 1e-9; }},
    {"a point off its lattice", "lattice", [](TetMesh& m) { m.points[100].x += 1; }},
    {"a point moved far", "orientation", [](TetMesh& m) { m.points[100].x += 40; }},
    {"level 0", "lattice", [](TetMesh& m) { m.levels[100] = 0; }},
    {"a wrong level", "lattice", [](TetMesh& m) { m.levels.back() = 9; }},
    {"not a number", "coordinates",
     [](TetMesh& m) { m.points[3].y = std::numeric_limits<double>::quiet_NaN(); }},
    {"infinite", "coordinates", [](TetMesh& m) { m.points[3].y = std::numeric_limits<double>::infinity(); }},
    {"beyond the grid", "coordinates", [](TetMesh& m) { m.points[3].y = 1e30; }},
    {"two points at one place", "conformity",
     [](TetMesh& m) {
       m.points.push_back(m.points[100]);
       m.levels.push_back(m.levels[100]);
       m.tets[7][2] = VertexId(m.points.size() - 1);
     }},
    {"bad frame", "coordinates", [](TetMesh& m) { m.frame->unit = 0; }},
    {"no points", "index",
     [](TetMesh& m) {
       m.points.clear();
       m.levels.clear();
     }},
};

TEST(VerifyStream, FindsPlantedFaults) {
  for (const Fault& fault : kFaults) {
    SCOPED_TRACE(fault.name);
    Arrays arrays = lattice_mesh(5);
    fault.plant(arrays.mesh);
    const VerifyReport report = judge(arrays);
    ASSERT_FALSE(report.ok);
    EXPECT_TRUE(found(report, fault.check)) << report.findings.front().check;
  }
}

/// All tetrahedra at one vertex: what is held is bounded all the same.
TEST(VerifyStream, RefusesCrowdsOfFacets) {
  Arrays arrays = lattice_mesh(2);
  arrays.mesh.tets.assign(1'100'000, arrays.mesh.tets[0]);
  const VerifyReport report = judge(arrays);
  ASSERT_FALSE(report.findings.empty());
  EXPECT_NE(report.findings.front().message.find("4,400,000 facets"), std::string::npos);
}

TEST(VerifyStream, FindsBadAngles) {
  Arrays arrays = lattice_mesh(5);
  StreamVerifyOptions options;
  options.guarantee = QualityGuarantee{60.5, 135, 2};
  EXPECT_TRUE(found(verify_stream(arrays, options), "dihedral"));
  options.guarantee = QualityGuarantee{60, 90, 2};
  EXPECT_TRUE(verify_stream(arrays, options).ok);
  options.guarantee = QualityGuarantee{60, 90, 0.6};
  EXPECT_TRUE(found(verify_stream(arrays, options), "radius-edge"));
}

TEST(VerifyStream, CanBeCancelled) {
  Arrays arrays = lattice_mesh(5);
  Control control;
  control.cancelled = [] { return true; };
  EXPECT_TRUE(found(verify_stream(arrays, {}, control), "cancelled"));
}

}  // namespace
}  // namespace unsliver
