#include <cstdlib>

#include "io/readers.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

using Parse = PointSet (*)(std::string_view, const std::string&);

void expect_points(const PointSet& set, const std::vector<Vec3>& points, const std::vector<double>& sizes) {
  expect_same_points(set.points, points);
  EXPECT_EQ(set.sizes, sizes);
}

void expect_fault(Parse parse, const std::string& bytes, ErrorCode code, const std::string& fragment) {
  SCOPED_TRACE(bytes);
  expect_error(code, {"a.txt", fragment}, [&] { parse(bytes, "a.txt"); });
}

const std::vector<Vec3> kThree{{0.1, -0.0, 1e22}, {5e-324, 2, -3}, {0.1, -0.0, 1e22}};

TEST(Xyz, ReadsPlainLinesInOrderWithDuplicates) {
  expect_points(parse_xyz("# made by hand\n\n0.1 -0 1e22\n\t5e-324  +2 -3 # a comment\r\n0.1 -0 1e22", "a"),
                kThree, {});
}

TEST(Xyz, ReadsTheChemistsForm) {
  const std::string rows = "O 0.1 -0 1e22\nH1 5e-324 2 -3 0.25 1\n8 0.1 -0 1e22\n";
  for (const char* comment : {"", "water", "1 2 3", "# 7", "energy=-3 frame 1"})
    expect_points(parse_xyz("3\n" + std::string(comment) + "\n" + rows + "\n \n", "a"), kThree, {});
}

TEST(Xyz, NamesFaults) {
  expect_fault(parse_xyz, "", ErrorCode::kBadInput, "the file is empty; expected an XYZ file");
  expect_fault(parse_xyz, " \n\n", ErrorCode::kBadInput, "the file is empty");
  expect_fault(parse_xyz, "# only this\n", ErrorCode::kFormat, "some other text, '# only this'");
  expect_fault(parse_xyz, "H 0 0 0\n", ErrorCode::kFormat, "a line with the number of atoms");
  expect_fault(parse_xyz, "PK\x03\x04....", ErrorCode::kFormat, "a zip archive; unpack it first");
  expect_fault(parse_xyz, "0 0 0\n1 1\n", ErrorCode::kFormat,
               "a.txt:2: point 1: the line ends where coordinate z");
  expect_fault(parse_xyz, "0 0 0\n\n1 1 1 4\n", ErrorCode::kFormat,
               "a.txt:3: point 1: the line has more than the 3 columns");
  expect_fault(parse_xyz, "0 0 0\n1 x 1\n", ErrorCode::kFormat,
               "expected coordinate y (a number), found 'x'");
  expect_fault(parse_xyz, "0 0 0\n1 nan 1\n", ErrorCode::kBadInput, "a.txt:2: point 1: coordinate y is nan");
  expect_fault(parse_xyz, "nan 0 0\n", ErrorCode::kBadInput, "a.txt:1: point 0: coordinate x is nan");
  expect_fault(parse_xyz, "0 0 -inf\n", ErrorCode::kBadInput, "coordinate z is -inf");
  expect_fault(parse_xyz, "0 0 1e999\n", ErrorCode::kBadInput, "coordinate z is inf");
  expect_fault(parse_xyz, "2\nwater\nH 0 0 0\n", ErrorCode::kFormat,
               "a.txt:4: atom 1: the file ends where an atom (the file's second line is a comment)");
  expect_fault(parse_xyz, "2\nwater\nH 0 0 0\nH 0 0\n", ErrorCode::kFormat,
               "a.txt:4: atom 1: the line ends where coordinate z");
  expect_fault(parse_xyz, "1\nwater\nH 0 0 0\n1\nwater\nH 0 0 1\n", ErrorCode::kUnsupported,
               "a.txt:4: more lines follow the 1 atoms that were declared; keep one frame");
  expect_fault(parse_xyz, "0\nnothing\n", ErrorCode::kBadInput, "the file has no points");
  expect_fault(parse_xyz, "-4\nx\n", ErrorCode::kFormat, "the number of atoms is -4");
  expect_fault(parse_xyz, "4000000000\nx\nH 0 0 0\n", ErrorCode::kFormat, "4000000000 atoms are declared");
  expect_fault(parse_xyz, "2.5\nx\nH 0 0 0\n", ErrorCode::kFormat, "the number of atoms (an integer)");
}

TEST(Csv, ReadsColumnsByName) {
  const PointSet set = parse_csv(
      "id, \"Z\" ,X,note,y,Radius\n7,1e22,0.1,\"a, b\",-0,0.5\n8,-3,5e-324,,2,1e-3\r\n9,1e22,0.1,x,-0,2\n",
      "a");
  expect_points(set, kThree, {0.5, 1e-3, 2});
  EXPECT_EQ(set.notes, std::vector<std::string>{"a: columns not used: 'id', 'note'"});
}

TEST(Csv, ReadsPlainColumns) {
  expect_points(parse_csv("0.1,-0,1e22\n5e-324,2,-3\n0.1,-0,1e22", "a"), kThree, {});
  expect_points(parse_csv("0.1;-0;1e22;3\n\n5e-324;2;-3;2\n0.1;-0;1e22;1\n", "a"), kThree, {3, 2, 1});
  expect_points(parse_csv("0.1\t-0\t1e22\n5e-324\t2\t-3\n0.1\t-0\t1e22\n", "a"), kThree, {});
}

TEST(Csv, AHeaderMayBeAComment) {
  const std::string rows = "1,0.1,-0,1e22\n2,5e-324,2,-3\n# more, or less\n3,0.1,-0,1e22\n";
  expect_points(parse_csv("# made by x, y and others\n#id,x,y,z\n" + rows, "a"), kThree, {});
  expect_points(parse_csv("# made by hand\n0.1,-0,1e22\n#x\n5e-324,2,-3\n0.1,-0,1e22\n", "a"), kThree, {});
}

TEST(Csv, KnowsTheNamesOfOthers) {
  for (const char* header :
       {"x,y,z,size", "X,Y,Z,s", "Points:0,Points:1,Points:2,Radius", "\xef\xbb\xbfx,y,z,s"})
    expect_points(parse_csv(header + std::string("\n1,2,3,4\n"), "a"), {{1, 2, 3}}, {4});
}

TEST(Csv, NamesFaults) {
  expect_fault(parse_csv, "", ErrorCode::kBadInput, "the file is empty; expected a CSV file of points");
  expect_fault(parse_csv, "x,y,z\n", ErrorCode::kBadInput, "the file has a header, but no points");
  expect_fault(parse_csv, "x,y,size\n1,2,3\n", ErrorCode::kFormat, "a.txt:1: expected a CSV file of points");
  expect_fault(parse_csv, "0 0 0\n", ErrorCode::kFormat, "found '0 0 0'");
  expect_fault(parse_csv, "x,y,z,X\n1,2,3,4\n", ErrorCode::kFormat,
               "a.txt:1: columns 1 and 4 mean the same, 'x' and 'X'; keep one");
  expect_fault(parse_csv, "x,y,z,s,radius\n1,2,3,4,5\n", ErrorCode::kFormat, "columns 4 and 5 mean the same");
  expect_fault(parse_csv, "1,2\n", ErrorCode::kFormat, "a.txt:1: point 0: the row has 2 columns");
  expect_fault(parse_csv, "1,2,3,4,5\n", ErrorCode::kFormat, "the row has 5 columns; without a header");
  expect_fault(parse_csv, "1,2,3\n\n1,2\n", ErrorCode::kFormat,
               "a.txt:3: point 1: the row has 2 columns, but the first one has 3");
  expect_fault(parse_csv, "x,y,z\n1,2,3\n1,2,3,4\n", ErrorCode::kFormat, "a.txt:3: point 1: the row has 4");
  expect_fault(parse_csv, "x,y,z\n1,,3\n", ErrorCode::kFormat,
               "a.txt:2: point 0: expected coordinate y (a number), found ''");
  expect_fault(parse_csv, "1;2,5;3\n", ErrorCode::kFormat, "found '2,5'");
  expect_fault(parse_csv, "1,2,nan\n", ErrorCode::kBadInput, "a.txt:1: point 0: coordinate z is nan");
  expect_fault(parse_csv, "1,2,inf\n", ErrorCode::kBadInput, "coordinate z is inf");
  expect_fault(parse_csv, "1,2,3,0.1\n1,2,3,0\n", ErrorCode::kBadInput,
               "a.txt:2: point 1: the size is 0, but a size must be positive");
  expect_fault(parse_csv, "1,2,3,-0.5\n", ErrorCode::kBadInput, "the size is -0.5");
  expect_fault(parse_csv, "1,2,3,nan\n", ErrorCode::kBadInput, "the size is nan");
  expect_fault(parse_csv, "x,y,z,size\n1,2,3,\n", ErrorCode::kFormat,
               "expected the size (a number), found ''");
}

TEST(Pqr, ReadsRecordsWithAndWithoutChain) {
  const PointSet set = parse_pqr(
      "REMARK 1 2 3\nATOM  1 N   MET   1   0.1 -0 1e22 -0.3 1.85\n"
      "HETATM10000 O HOH A -12B 5e-324 2 -3 -0.8 0.2245\nTER\n"
      "ATOM  3 CA  MET A 1   0.1 -0 1e22 0.21 2\nEND\n",
      "a");
  expect_points(set, kThree, {1.85, 0.2245, 2});
}

TEST(Pqr, NamesFaults) {
  const std::string good = "ATOM 1 N MET 1 0 0 0 -0.3 1.85\n";
  expect_fault(parse_pqr, "", ErrorCode::kBadInput, "the file is empty; expected a PQR file");
  expect_fault(parse_pqr, "REMARK only\nEND\n", ErrorCode::kFormat, "a PQR file with ATOM or HETATM records");
  expect_fault(parse_pqr, good + "ATOM 2 N MET 1 0 0 0\n", ErrorCode::kFormat,
               "a.txt:2: atom 1: the record has 8 fields; expected 'ATOM number name residue chain");
  expect_fault(parse_pqr, good + "ATOM 2 N MET A 1 0 0 0 -0.3 1.85 7\n", ErrorCode::kFormat,
               "the record has more than 11 fields");
  expect_fault(parse_pqr, good + "ATOM 2 N MET 1 0 0 0 -0.3\n", ErrorCode::kFormat,
               "expected a residue number before x y z charge radius, found 'MET'");
  expect_fault(parse_pqr, "ATOM 2 N MET A 1 0 0 0 -0.3\n", ErrorCode::kFormat,
               "found 'A'; is a field missing?");
  expect_fault(parse_pqr, "ATOM 1 N MET 1 0 zero 0 -0.3 1.85\n", ErrorCode::kFormat,
               "expected coordinate y (a number), found 'zero'");
  expect_fault(parse_pqr, "ATOM 1 N MET 1 0 0 nan -0.3 1.85\n", ErrorCode::kBadInput, "coordinate z is nan");
  expect_fault(parse_pqr, "ATOM 1 N MET 1 0 0 0 -0.3 0.000\n", ErrorCode::kBadInput,
               "a.txt:1: atom 0: the radius is 0, but a size must be positive; give one");
  expect_fault(parse_pqr, "ATOM 1 N MET 1 0 0 0 -0.3 -1\n", ErrorCode::kBadInput, "the radius is -1");
}

TEST(Node, ReadsPointsAndSkipsAttributes) {
  expect_points(parse_node("3 3 1 1\n0 0.1 -0 1e22 7 1\n1 5e-324 2 -3 8 0\n2 0.1 -0 1e22 9 0\n", "a"), kThree,
                {});
  expect_points(parse_node("3 3\n1 0.1 -0 1e22\n2 5e-324 2 -3\n3 0.1 -0 1e22\n", "a"), kThree, {});
  expect_fault(parse_node, "0 3 0 0\n", ErrorCode::kBadInput, "the file has no points");
  expect_fault(parse_node, "2 3 0 0\n1 0 0 0    \n   \n", ErrorCode::kFormat,
               "a.txt:4: node 1: the file ends");
  expect_fault(parse_node, "1 3\n1 0 0\n", ErrorCode::kFormat, "the line ends where coordinate z");
}

/// Every file has the three points, in an order of its own, and whatever else its format needs.
struct Sample {
  const char* name;
  const char* bytes;
};
constexpr Sample kSamples[] = {
    {"a.xyz", "0 0 0\n1 0 0\n0 1 0.5\n"},
    {"a.csv", "0,0,0\n1,0,0\n0,1,0.5\n"},
    {"a.PQR", "ATOM 1 N M 1 0 0 0 0 1\nATOM 1 N M 1 1 0 0 0 1\nATOM 1 N M 1 0 1 .5 0 1\n"},
    {"a.node", "3 3\n1 0 0 0\n2 1 0 0\n3 0 1 0.5\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0.5\n"},
    {"a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0.5\n"},
    {"a.ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
     "end_header\n0 0 0\n1 0 0\n0 1 0.5\n"},
    {"a.stl",
     "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0.5\nendloop\n"
     "endfacet\nendsolid\n"},
    {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0.5 0\nEnd\n"},
    {"a.msh",
     "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0.5\n$EndNodes\n"
     "$Elements\n0\n$EndElements\n"},
    {"a.vtu",
     "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
     "NumberOfCells=\"0\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
     "format=\"ascii\">0 0 0 1 0 0 0 1 0.5</DataArray></Points><Cells><DataArray type=\"Int64\" "
     "Name=\"connectivity\" format=\"ascii\"></DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
     "format=\"ascii\"></DataArray><DataArray type=\"UInt8\" Name=\"types\" "
     "format=\"ascii\"></DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"},
};

TEST(ReadPoints, TakesTheVerticesOfEveryFormat) {
  TemporaryFolder folder;
  for (const Sample& sample : kSamples) {
    SCOPED_TRACE(sample.name);
    put_file(folder / sample.name, sample.bytes);
    expect_same_points(read_points(folder / sample.name).points, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}});
  }
}

TEST(ReadPoints, TakesTheVerticesOfTetrahedra) {
  TemporaryFolder folder;
  for (const char* name : {"m.vtu", "m.msh", "m.mesh", "m.node", "m.ele"}) {
    SCOPED_TRACE(name);
    write_tet_mesh(folder / name, sample_mesh());
    expect_same_points(read_points(folder / name).points, sample_mesh().points);
  }
}

TEST(ReadPoints, NeedsNoTetrahedraBesideNodes) {
  TemporaryFolder folder;
  put_file(folder / "a.node", "1 3\n1 0 0 0\n");
  EXPECT_EQ(read_points(folder / "a.ele").points.size(), 1u);
  EXPECT_EQ(read_points(folder / "a.node").points.size(), 1u);
}

TEST(ReadPoints, RefusesFilesWithoutPointsAndUnknownOnes) {
  TemporaryFolder folder;
  const auto expect = [&](ErrorCode code, const char* name, const char* bytes, const char* fragment) {
    put_file(folder / name, bytes);
    expect_error(code, {name, fragment}, [&] { read_points(folder / name); });
  };
  expect(ErrorCode::kUnsupported, "a.pdf", "0 0 0\n",
         "'.pdf' is no extension of a file of points; known are");
  expect(ErrorCode::kUnsupported, "points", "0 0 0\n", "none is no extension of a file of points");
  expect(ErrorCode::kBadInput, "a.off", "OFF\n0 0 0\n", "the file has no points");
  expect(ErrorCode::kBadInput, "a.mesh", "MeshVersionFormatted 2\nEnd\n", "the file has no points");
  for (const Sample& sample : kSamples) expect(ErrorCode::kBadInput, sample.name, "", "the file is empty");
  expect_error(ErrorCode::kIo, {"absent.xyz"}, [&] { read_points(folder / "absent.xyz"); });
}

TEST(ReadPoints, FormatsAreNamed) {
  EXPECT_EQ(point_formats(), (std::vector<std::string>{"xyz", "csv", "pqr", "node"}));
}

TEST(RealData, AMoleculeHasItsAtomsAndRadii) {
  const char* folder = std::getenv("UNSLIVER_DATA");
  if (!folder) GTEST_SKIP() << "UNSLIVER_DATA names no folder";
  const PointSet set = read_points(std::filesystem::path(folder) / "1a63.pqr");
  ASSERT_EQ(set.points.size(), 2065u);
  ASSERT_EQ(set.sizes.size(), 2065u);
  EXPECT_EQ(set.points.front(), (Vec3{-6.406, 5.469, -3.259}));
  EXPECT_EQ(set.points.back(), (Vec3{30.276, 4.227, -1.754}));
  EXPECT_EQ(set.sizes.front(), 1.85);
  EXPECT_EQ(set.sizes.back(), 1.7);
  EXPECT_TRUE(set.notes.empty());
}

}  // namespace
}  // namespace unsliver::io
