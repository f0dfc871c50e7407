#include "io/readers.hpp"
#include "io_test_util.hpp"

namespace unsliver::io {
namespace {

const std::string kHead = "# by hand\nMeshVersionFormatted 2\nDimension\n3\n";
const std::string kVertices = "Vertices\n4\n0 0 0 0\n0.1 0 0 1\n0 1 0 1\n0 0 1e-5 2\n";

TEST(Medit, ReadsLabelsAndSkipsOtherSections) {
  const TetMesh mesh =
      parse_medit(kHead + kVertices +
                      "Edges\n1\n1 2 9\nNormals 1\n0.5 -1e-3 0\nRequiredVertices 2 1 2\n"
                      "Triangles 1\n1 2 3 6\nTetrahedra\n2\n1 2 3 4 5\n4 3 2 1 -5\nEnd\nrubbish",
                  "a.mesh");
  expect_same_points(mesh.points, {{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1e-5}});
  EXPECT_EQ(mesh.tets, (std::vector<std::array<VertexId, 4>>{{0, 1, 2, 3}, {3, 2, 1, 0}}));
  EXPECT_EQ(mesh.regions, (std::vector<std::int32_t>{5, -5}));
  EXPECT_EQ(mesh.triangle_labels, std::vector<std::int32_t>{6});
}

TEST(Medit, NamesFaults) {
  const auto expect = [](ErrorCode code, const std::string& text, const std::string& fragment) {
    expect_error(code, {fragment}, [&] { parse_medit(text, "a.mesh"); });
  };
  const std::string body = kHead + kVertices;
  expect(ErrorCode::kBadInput, body + "Tetrahedra\n2\n1 2 3 4 5\n1 2 3 5 5\n",
         "a.mesh:14: tetrahedron 2: vertex index 5 is out of range; valid are 1 to 4");
  expect(ErrorCode::kBadInput, body + "Tetrahedra\n1\n0 2 3 4 5\n", "vertex index 0 is out of range");
  expect(ErrorCode::kBadInput, kHead + "Tetrahedra\n1\n1 2 3 4 5\n", "there are no vertices");
  expect(ErrorCode::kBadInput, kHead + "Vertices\n1\n0 inf 0 0\n", "a.mesh:7: vertex 1: coordinate y is inf");
  expect(ErrorCode::kFormat, body + "Tetrahedra\n2\n1 2 3 4 500000\n1 2 3\n",
         "the file ends where a vertex index");
  expect(ErrorCode::kFormat, body + "Tetrahedra\n4000000000\n1 2 3 4 5\n",
         "4000000000 elements are declared");
  expect(ErrorCode::kFormat, kHead + "Vertices 4000000000\n1 2 3 4\n", "a.mesh:5: 4000000000 vertices");
  expect(ErrorCode::kFormat, body + kVertices, "a second section 'Vertices'");
  expect(ErrorCode::kFormat, kHead + "7\n", "a.mesh:5: expected a keyword, found '7'");
  expect(ErrorCode::kUnsupported, "MeshVersionFormatted 2\nDimension 2\n",
         "a.mesh:2: the dimension is 2, not 3");
  expect(ErrorCode::kBadInput, body, "no linear tetrahedra");
  expect(ErrorCode::kBadInput, "", "a.mesh: the file is empty; expected a MEDIT text file");
  expect(ErrorCode::kFormat, "8 3 0 0\n", "expected a MEDIT text file");
}

const std::string kSolHead = "MeshVersionFormatted 2\nDimension 3\n";

TEST(Sol, ReadsOneScalarField) {
  EXPECT_EQ(parse_sol(kSolHead + "Other 1 2 3\nSolAtVertices\n2\n1 1\n0.5\n1e-3\nEnd\n", "a.sol", 2),
            (std::vector<double>{0.5, 1e-3}));
}

TEST(Sol, NamesFaults) {
  const auto expect = [](ErrorCode code, const std::string& text, const std::string& fragment) {
    expect_error(code, {fragment}, [&] { parse_sol(text, "a.sol", 2); });
  };
  expect(ErrorCode::kBadInput, kSolHead + "SolAtVertices\n3\n1 1\n1\n1\n1\n",
         "3 values are given for 2 vertices");
  expect(ErrorCode::kUnsupported, kSolHead + "SolAtVertices\n2\n1 3\n1 0 0 1 0 1\n", "one scalar field");
  expect(ErrorCode::kBadInput, kSolHead + "SolAtVertices\n2\n1 1\n1\nnan\n",
         "a.sol:7: value 2: a size is nan");
  expect(ErrorCode::kFormat, kSolHead + "SolAtVertices\n2\n1 1\n1\n",
         "the file ends where a size was expected");
  expect(ErrorCode::kFormat, kSolHead, "the file ends where SolAtVertices was expected");
}

}  // namespace
}  // namespace unsliver::io
