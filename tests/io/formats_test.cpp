#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

TEST(Formats, ListsNames) {
  EXPECT_EQ(surface_formats(), (std::vector<std::string>{"stl", "obj", "off", "ply"}));
  EXPECT_EQ(tet_mesh_formats(), (std::vector<std::string>{"vtu", "msh22", "msh41", "medit", "tetgen"}));
}

TEST(Formats, EveryListedFormatWrites) {
  TemporaryFolder folder;
  for (const std::string& format : tet_mesh_formats()) {
    write_tet_mesh(folder / ("mesh." + format), sample_mesh(),
                   {.format = format, .ascii = false, .min_dihedral_deg = {}});
  }
  EXPECT_EQ(folder.list().size(), 4u + 3u);
}

TEST(Formats, ExtensionsCountInAnyCase) {
  TemporaryFolder folder;
  put_file(folder / "A.Off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const TriangleMesh mesh = read_surface(folder / "A.Off");
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.name, (folder / "A.Off").string());
}

TEST(Formats, NamesKnownExtensions) {
  expect_error(ErrorCode::kUnsupported, {"'a.step'", "'.step'", ".stl, .obj, .off and .ply"},
               [] { read_surface("a.step"); });
  expect_error(ErrorCode::kUnsupported, {"'a'", "none is no extension", ".vtu"}, [] { read_tet_mesh("a"); });
  expect_error(ErrorCode::kUnsupported, {"'.vtu' is the extension of a tetrahedral mesh, not of a surface"},
               [] { read_surface("a.vtu"); });
  expect_error(ErrorCode::kUnsupported, {"'.csv' is the extension of a file of points"},
               [] { read_tet_mesh("a.csv"); });
  expect_error(ErrorCode::kUnsupported, {"'a.stl'", ".msh"}, [] { write_tet_mesh("a.stl", sample_mesh()); });
  expect_error(ErrorCode::kUnsupported, {"sizing mesh", ".sol"}, [] { read_sizing_mesh("a.vtu"); });
}

TEST(Formats, NamesFilesThatCannotBeRead) {
  TemporaryFolder folder;
  expect_error(ErrorCode::kIo, {"cannot read", "none.stl"}, [&] { read_surface(folder / "none.stl"); });
  std::filesystem::create_directory(folder / "folder.vtu");
  expect_error(ErrorCode::kIo, {"cannot read", "folder.vtu"}, [&] { read_tet_mesh(folder / "folder.vtu"); });
}

TEST(Formats, RefusesEmptyFilesEverywhere) {
  TemporaryFolder folder;
  for (const char* name : {"a.stl", "a.obj", "a.off", "a.ply"}) {
    put_file(folder / name, "");
    expect_error(ErrorCode::kBadInput, {name, "the file is empty; expected"},
                 [&] { read_surface(folder / name); });
  }
  put_file(folder / "a.ele", "");
  for (const char* name : {"a.vtu", "a.msh", "a.mesh", "a.node"}) {
    put_file(folder / name, "");
    expect_error(ErrorCode::kBadInput, {name, "the file is empty; expected"},
                 [&] { read_tet_mesh(folder / name); });
  }
}

TEST(Formats, SaysWhatWrongFilesLookLike) {
  TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> contents{{"\x1f\x8b\x08", "gzip"},
                                                                  {"PK\x03\x04", "zip"},
                                                                  {"<!DOCTYPE html>", "a web page"},
                                                                  {"<?xml version", "an XML file"},
                                                                  {"# vtk DataFile 3.0", "legacy VTK"},
                                                                  {std::string("\0\1\2", 3), "binary data"},
                                                                  {"hello", "some other text"}};
  for (const auto& [content, meaning] : contents) {
    put_file(folder / "a.off", content);
    expect_error(ErrorCode::kFormat, {"a.off", "OFF", meaning}, [&] { read_surface(folder / "a.off"); });
  }
}

TEST(Formats, OptionsWithoutEffectAreErrors) {
  TemporaryFolder folder;
  expect_error(ErrorCode::kBadOption, {"'vtk'", "vtu, msh22, msh41, medit, tetgen"}, [&] {
    write_tet_mesh(folder / "a.vtu", sample_mesh(),
                   {.format = "vtk", .ascii = false, .min_dihedral_deg = {}});
  });
  expect_error(ErrorCode::kBadOption, {"ascii"}, [&] {
    write_tet_mesh(folder / "a.vtu", sample_mesh(), {.format = "", .ascii = true, .min_dihedral_deg = {}});
  });
  expect_error(ErrorCode::kBadOption, {"1 values of min_dihedral_deg are given for 2"}, [&] {
    write_tet_mesh(folder / "a.vtu", sample_mesh(), {.format = "", .ascii = false, .min_dihedral_deg = {1}});
  });
  EXPECT_TRUE(folder.list().empty());
}

TEST(Formats, RefusesInconsistentMeshes) {
  TemporaryFolder folder;
  const auto expect = [&](const std::string& fragment, const auto& spoil) {
    TetMesh mesh = sample_mesh();
    spoil(mesh);
    expect_error(ErrorCode::kBadInput, {fragment}, [&] { write_tet_mesh(folder / "a.vtu", mesh); });
  };
  expect("'regions' has 1 entries for 2", [](TetMesh& m) { m.regions.pop_back(); });
  expect("'levels' has 4 entries for 5", [](TetMesh& m) { m.levels.pop_back(); });
  expect("'point_source' has 6 entries", [](TetMesh& m) { m.point_source.push_back(0); });
  expect("'triangle_labels' has 2 entries", [](TetMesh& m) { m.triangle_labels.pop_back(); });
  expect("tetrahedron 1 of the mesh uses vertex 5", [](TetMesh& m) { m.tets[1][2] = 5; });
  expect("triangle 0 of the mesh uses vertex 9", [](TetMesh& m) { m.triangles[0][0] = 9; });
  EXPECT_TRUE(folder.list().empty());
}

TEST(SizingMesh, ReadsMeditPairsByEitherName) {
  TemporaryFolder folder;
  write_tet_mesh(folder / "a.mesh", sample_mesh());
  put_file(folder / "a.sol",
           "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n5\n1 1\n1\n2\n3\n4\n5.5\nEnd\n");
  for (const char* name : {"a.mesh", "a.sol"}) {
    const NodalField field = read_sizing_mesh(folder / name);
    EXPECT_EQ(field.values, (std::vector<double>{1, 2, 3, 4, 5.5}));
    EXPECT_EQ(field.mesh.tets, sample_mesh().tets);
  }
  std::filesystem::remove(folder / "a.sol");
  expect_error(ErrorCode::kIo, {"a.sol"}, [&] { read_sizing_mesh(folder / "a.mesh"); });
}

TEST(SizingMesh, ReadsTetgenTriplesByAnyName) {
  TemporaryFolder folder;
  write_tet_mesh(folder / "a.node", sample_mesh());
  put_file(folder / "a.mtr", "5 1\n1\n2\n3\n4\n5.5\n");
  for (const char* name : {"a.node", "a.ele", "a.mtr"})
    EXPECT_EQ(read_sizing_mesh(folder / name).values, (std::vector<double>{1, 2, 3, 4, 5.5}));
}

}  // namespace
}  // namespace unsliver::io
