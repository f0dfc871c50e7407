#include "io/readers.hpp"
#include "io_test_util.hpp"

namespace unsliver::io {
namespace {

using Triangles = std::vector<std::array<VertexId, 3>>;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\n";

TEST(Obj, ReadsAllFormsOfCorners) {
  for (const char* face :
       {"f 1 2 3", "f 1/7 2/8 3/9", "f 1//7 2//8 3//9", "f 1/7/7 2/8/8 3/9/9", "f -4 -3 -2",
        "f -4//-1 -3//-1 -2//-1", "  f\t1  2 3  # first", "f 1 \\\n 2 \\\r\n 3"}) {
    SCOPED_TRACE(face);
    EXPECT_EQ(parse_obj(kSquare + face, "a.obj").triangles, (Triangles{{0, 1, 2}}));
  }
}

TEST(Obj, FansPolygons) {
  EXPECT_EQ(parse_obj(kSquare + "f 1 2 3 4\n", "a.obj").triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Obj, KeepsCoordinatesAndIgnoresTheRest) {
  const TriangleMesh mesh = parse_obj(
      "\xef\xbb\xbf# head\r\nmtllib a.mtl\r\no part\r\nv 0.1 -0 1e-3 1 0.5 0.5 0.5\r\nvn nan nan nan\r\n"
      "vt 0 x\r\nv 1 2 3 1.0\r\ng a b\r\nv 4 5 6\r\nusemtl m\r\ns off\r\nl 1 2\r\nf 1 2 3\r\n",
      "a.obj");
  expect_same_points(mesh.points, {{0.1, -0.0, 1e-3}, {1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
}

TEST(Obj, TakesVerticesThatFollow) {
  EXPECT_EQ(parse_obj("f 1 2 3\n" + kSquare, "a.obj").triangles, (Triangles{{0, 1, 2}}));
}

TEST(Obj, NegativeIndicesCountFromTheFacesPlace) {
  EXPECT_EQ(parse_obj(kSquare + "f -1 -2 -3\n" + kSquare + "f -1 -2 -3\n", "a.obj").triangles,
            (Triangles{{3, 2, 1}, {7, 6, 5}}));
}

TEST(Obj, NamesTheIndexOutOfRange) {
  expect_error(ErrorCode::kBadInput, {"a.obj:6: face 2: vertex index 5 is out of range; valid are 1 to 4"},
               [] { parse_obj(kSquare + "f 1 2 3\nf 1 2 5\n", "a.obj"); });
  expect_error(ErrorCode::kBadInput, {"a.obj:5: face 1: vertex index 0 is out of range"},
               [] { parse_obj(kSquare + "f 0 1 2\n", "a.obj"); });
  expect_error(ErrorCode::kBadInput, {"a.obj:5: face 1: vertex index -5 counts back past the 4 vertices"},
               [] { parse_obj(kSquare + "f -5 1 2\n", "a.obj"); });
  expect_error(ErrorCode::kBadInput, {"a.obj:5: face 1: vertex index 4294967296 is out of range"},
               [] { parse_obj(kSquare + "f 4294967296 1 2\n", "a.obj"); });
}

TEST(Obj, RefusesBrokenLines) {
  expect_error(ErrorCode::kFormat, {"a.obj:2: vertex 2: the line ends where coordinate z was expected"},
               [] { parse_obj("v 0 0 0\nv 1 1\nv 2 2 2\nf 1 2 3\n", "a.obj"); });
  expect_error(ErrorCode::kBadInput, {"a.obj:1: vertex 1: coordinate y is nan"},
               [] { parse_obj("v 0 nan 0\n", "a.obj"); });
  expect_error(ErrorCode::kFormat, {"a.obj:5: face 1: it has 2 corners"},
               [] { parse_obj(kSquare + "f 1 2\n", "a.obj"); });
  expect_error(ErrorCode::kFormat, {"a.obj:5: face 1: expected a vertex index (an integer), found 'x'"},
               [] { parse_obj(kSquare + "f 1 x 2\n", "a.obj"); });
}

TEST(Obj, RefusesFilesWithoutASurface) {
  expect_error(ErrorCode::kBadInput, {"no triangles"}, [] { parse_obj(kSquare, "a.obj"); });
  expect_error(ErrorCode::kBadInput, {"a.obj", "empty"}, [] { parse_obj(" \n", "a.obj"); });
  expect_error(ErrorCode::kFormat, {"a.obj", "expected an OBJ file", "a PLY file"},
               [] { parse_obj("ply\nformat ascii 1.0\n", "a.obj"); });
}

}  // namespace
}  // namespace unsliver::io
