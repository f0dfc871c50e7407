#include "io/readers.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

const std::string kNode0 =
    "# by hand\n4 3 2 1\n0 0 0 0 7 8 1\n1 0.1 0 0 7 8 0\n2 0 1 0 7 8 0\n3 0 0 1e-5 7 8 0\n";
const std::string kNode1 =
    "4  3  0  0\n   1    0 0 0\n   2    0.1 0 0\n   3    0 1 0\n   4    0 0 1e-5\n# end\n";

const std::vector<Vec3> kPoints{{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1e-5}};
const std::vector<std::array<VertexId, 4>> kTets{{0, 1, 2, 3}};

TEST(Tetgen, ReadsBothNumberings) {
  const TetMesh from0 = parse_tetgen({kNode0, "1 4 0\n0 0 1 2 3\n", ""}, "a");
  const TetMesh from1 = parse_tetgen({kNode1, "1 4 0\n1 1 2 3 4\n", ""}, "a");
  for (const TetMesh& mesh : {from0, from1}) {
    expect_same_points(mesh.points, kPoints);
    EXPECT_EQ(mesh.tets, kTets);
    EXPECT_TRUE(mesh.regions.empty());
  }
}

TEST(Tetgen, ReadsRegionsAndMarkers) {
  const TetMesh mesh = parse_tetgen(
      {kNode1, "2 4 1\n1 1 2 3 4 -5\n2 4 3 2 1 6.0\n", "2 1\n1 1 2 3 -1\n2 2 3 4 12 1 -1\n"}, "a");
  EXPECT_EQ(mesh.regions, (std::vector<std::int32_t>{-5, 6}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<VertexId, 3>>{{0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(mesh.triangle_labels, (std::vector<std::int32_t>{-1, 12}));
}

TEST(Tetgen, NamesFaults) {
  const auto expect = [](ErrorCode code, const std::string& node, const std::string& ele,
                         const std::string& face, const std::string& fragment) {
    expect_error(code, {fragment}, [&] { parse_tetgen({node, ele, face}, "a"); });
  };
  const std::string ele = "1 4 0\n1 1 2 3 4\n";
  expect(ErrorCode::kBadInput, kNode1, "1 4 0\n1 1 2 3 5\n", "",
         "a.ele:2: tetrahedron 1: vertex index 5 is out of range; valid are 1 to 4");
  expect(ErrorCode::kBadInput, kNode0, "1 4 0\n0 0 1 2 4\n", "", "valid are 0 to 3");
  expect(ErrorCode::kBadInput, kNode1, ele, "1 0\n1 1 2 0\n", "a.face:2: triangle 1: vertex index 0");
  expect(ErrorCode::kFormat, kNode1, "2 4 0\n1     1 2 3 4\n\n", "", "a.ele:4: tetrahedron 2: the file ends");
  expect(ErrorCode::kFormat, kNode1, "1 4 1\n1 1 2 3 4\n", "",
         "a.ele:2: tetrahedron 1: the line ends where a region");
  expect(ErrorCode::kBadInput, kNode1, "1 4 1\n1 1 2 3 4 0.5\n", "", "the region is 0.5");
  expect(ErrorCode::kUnsupported, kNode1, "1 10 0\n1 1 2 3 4 1 2 3 4 1 2\n", "", "tetrahedra of 10 nodes");
  expect(ErrorCode::kUnsupported, "1 2 0 0\n1 0 0\n", ele, "", "a.node:1: the dimension is 2");
  expect(ErrorCode::kFormat, "2 3 0 0\n1 0 0 0\n3 0 0 0\n", ele, "",
         "a.node:3: node 2: the row's index is 3, expected 2");
  expect(ErrorCode::kBadInput, "1 3 0 0\n1 0 nan 0\n", ele, "", "a.node:2: node 1: coordinate y is nan");
  expect(ErrorCode::kFormat, "4000000000 3 0 0\n1 0 0 0\n", ele, "",
         "a.node:1: 4000000000 nodes are declared");
  expect(ErrorCode::kFormat, kNode1, "4000000000 4 0\n1 1 2 3 4\n", "", "4000000000 tetrahedra are declared");
  expect(ErrorCode::kBadInput, "", ele, "", "a.node: the file is empty; expected a TetGen .node file");
  expect(ErrorCode::kBadInput, kNode1, "0 4 0\n", "", "a.ele: the file has no linear tetrahedra");
}

TEST(Mtr, ReadsOneValueANode) {
  EXPECT_EQ(parse_mtr("2 1\n0.5\n\n# c\n1e-3\n", "a.mtr", 2), (std::vector<double>{0.5, 1e-3}));
  expect_error(ErrorCode::kBadInput, {"a.mtr:1: 2 values are given for 3 nodes"},
               [] { parse_mtr("2 1\n1\n1\n", "a.mtr", 3); });
  expect_error(ErrorCode::kUnsupported, {"one value a node"},
               [] { parse_mtr("1 6\n1 0 0 1 0 1\n", "a.mtr", 1); });
  expect_error(ErrorCode::kFormat, {"a.mtr:2: value 0: expected a size (a number), found 'x'"},
               [] { parse_mtr("1 1\nx\n", "a.mtr", 1); });
}

TEST(Tetgen, AnyOfTheExtensionsNamesAllFiles) {
  TemporaryFolder folder;
  write_tet_mesh(folder / "part.1.face", sample_mesh());
  EXPECT_EQ(folder.list(), (std::vector<std::string>{"part.1.ele", "part.1.face", "part.1.node"}));
  for (const char* name : {"part.1.ele", "part.1.face", "part.1.node"})
    EXPECT_EQ(read_tet_mesh(folder / name).triangle_labels, sample_mesh().triangle_labels);
  std::filesystem::remove(folder / "part.1.face");
  EXPECT_TRUE(read_tet_mesh(folder / "part.1.node").triangles.empty());
  std::filesystem::remove(folder / "part.1.ele");
  expect_error(ErrorCode::kIo, {"part.1.ele"}, [&] { read_tet_mesh(folder / "part.1.node"); });
}

}  // namespace
}  // namespace unsliver::io
