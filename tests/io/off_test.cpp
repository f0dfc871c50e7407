#include "io/readers.hpp"
#include "io_test_util.hpp"

namespace unsliver::io {
namespace {

using Triangles = std::vector<std::array<VertexId, 3>>;

const std::string kVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n";

TEST(Off, ReadsCountsOnEitherLineWithOrWithoutEdges) {
  for (const char* head : {"OFF\n4 1 0\n", "OFF 4 1 0\n", "OFF\n4 1\n", "# c\n\nOFF # c\n# c\n4 1 0 # c\n\n",
                           "OFF\r\n4 1 0\r\n", "COFF\n4 1 0\n", "NOFF\n4 1 0\n", "STCNOFF 4 1 0\n"}) {
    SCOPED_TRACE(head);
    const TriangleMesh mesh = parse_off(head + kVertices + "3 0 1 2\n", "a.off");
    expect_same_points(mesh.points, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}});
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
  }
}

TEST(Off, SkipsColoursAndNormalsAndFansPolygons) {
  const TriangleMesh mesh = parse_off(
      "COFF\n4 2 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n\n1 1 0 0 0 0 1\n# c\n0 1 0 1 1 1 1\n"
      "4 0 1 2 3 255 0 0\n3  0 2 3  0.5 0.5 0.5\n",
      "a.off");
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
}

TEST(Off, NamesTheIndexOutOfRange) {
  expect_error(ErrorCode::kBadInput, {"a.off:8: face 1: vertex index 4 is out of range; valid are 0 to 3"},
               [] { parse_off("OFF\n4 2 0\n" + kVertices + "3 0 1 2\n3 0 1 4\n", "a.off"); });
  expect_error(ErrorCode::kBadInput, {"a.off:7: face 0: vertex index -1 is out of range"},
               [] { parse_off("OFF\n4 1 0\n" + kVertices + "3 0 1 -1\n", "a.off"); });
}

TEST(Off, RefusesBrokenFiles) {
  expect_error(ErrorCode::kFormat, {"a.off:9: face 1: the file ends where a face was expected"},
               [] { parse_off("OFF\n4 2 0\n" + kVertices + "3 0 1 2\n    \n", "a.off"); });
  expect_error(ErrorCode::kFormat, {"a.off:3: vertex 0: expected coordinate y (a number), found 'x'"},
               [] { parse_off("OFF\n4 1 0\n0 x 0\n" + kVertices, "a.off"); });
  expect_error(ErrorCode::kBadInput, {"a.off:3: vertex 0: coordinate x is inf"},
               [] { parse_off("OFF\n4 1 0\ninf 0 0\n" + kVertices, "a.off"); });
  expect_error(ErrorCode::kFormat, {"a.off:7: face 0: it has 2 corners"},
               [] { parse_off("OFF\n4 1 0\n" + kVertices + "2 0 1\n", "a.off"); });
  expect_error(ErrorCode::kFormat, {"a.off:7: face 0: the line ends where a vertex index was expected"},
               [] { parse_off("OFF\n4 1 0\n" + kVertices + "4 0 1 2\n3 1 2 3\n", "a.off"); });
}

TEST(Off, ChecksCountsBeforeTakingMemory) {
  expect_error(ErrorCode::kFormat, {"a.off:2: 4000000000 vertices are declared"},
               [] { parse_off("OFF\n4000000000 1 0\n" + kVertices, "a.off"); });
  expect_error(ErrorCode::kFormat, {"a.off:2: 1000000000000 faces are declared"},
               [] { parse_off("OFF\n4 1000000000000 0\n" + kVertices, "a.off"); });
  expect_error(ErrorCode::kFormat, {"a.off:7: face 0: 2000000000 corners are declared"},
               [] { parse_off("OFF\n4 1 0\n" + kVertices + "2000000000 0 1 2\n", "a.off"); });
  expect_error(ErrorCode::kFormat, {"the number of vertices is -4"},
               [] { parse_off("OFF\n-4 1 0\n" + kVertices, "a.off"); });
}

TEST(Off, RefusesOtherKinds) {
  expect_error(ErrorCode::kUnsupported, {"a.off:1: ", "'4OFF'"}, [] { parse_off("4OFF\n1 1 0\n", "a.off"); });
  expect_error(ErrorCode::kUnsupported, {"binary OFF"}, [] { parse_off("OFF BINARY\n", "a.off"); });
  expect_error(ErrorCode::kBadInput, {"a.off", "empty"}, [] { parse_off("", "a.off"); });
  expect_error(ErrorCode::kFormat, {"expected an OFF file", "some other text"},
               [] { parse_off("4 1 0\n" + kVertices, "a.off"); });
  expect_error(ErrorCode::kBadInput, {"no triangles"},
               [] { parse_off("OFF\n4 0 0\n" + kVertices, "a.off"); });
}

}  // namespace
}  // namespace unsliver::io
