#include "io/readers.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

using Tets = std::vector<std::array<VertexId, 4>>;
using Labels = std::vector<std::int32_t>;

const std::string kHead22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string kNodes22 = "$Nodes\n5\n10 0 0 0\n7 0.1 0 0\n3 0 1 0\n99 0 0 1\n4 1 1 1e-5\n$EndNodes\n";

std::string msh22(const std::string& elements, const std::string& nodes = kNodes22) {
  return kHead22 + "$PhysicalNames\n1\n3 5 \"rock $Nodes\"\n$EndPhysicalNames\n" + nodes + "$Elements\n" +
         elements + "$EndElements\n$NodeData\n1\nx\n$EndNodeData\n";
}

TEST(Msh22, ReadsSparseTagsAndSkipsOtherElements) {
  const TetMesh mesh = parse_msh(
      msh22("4\n1 15 2 0 1 10\n2 2 2 6 1 10 7 3\n3 4 2 5 1 10 7 3 99\n4 4 3 0 8 2 7 3 99 4\n"), "a.msh");
  expect_same_points(mesh.points, {{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1e-5}});
  EXPECT_EQ(mesh.tets, (Tets{{0, 1, 2, 3}, {1, 2, 3, 4}}));
  EXPECT_EQ(mesh.regions, (Labels{5, 8}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<VertexId, 3>>{{0, 1, 2}}));
  EXPECT_EQ(mesh.triangle_labels, Labels{6});
}

TEST(Msh22, LabelsThatTellNothingApartAreDropped) {
  EXPECT_TRUE(parse_msh(msh22("2\n1 4 2 0 1 10 7 3 99\n2 4 2 0 1 7 3 99 4\n"), "a.msh").regions.empty());
  EXPECT_EQ(parse_msh(msh22("2\n1 4 2 0 1 10 7 3 99\n2 4 2 0 2 7 3 99 4\n"), "a.msh").regions,
            (Labels{1, 2}));
  EXPECT_TRUE(parse_msh(msh22("1\n1 4 0 10 7 3 99\n"), "a.msh").regions.empty());
}

TEST(Msh22, NamesFaults) {
  const auto expect = [](ErrorCode code, const std::string& text, const std::string& fragment) {
    expect_error(code, {fragment}, [&] { parse_msh(text, "a.msh"); });
  };
  expect(ErrorCode::kBadInput, msh22("1\n1 4 2 0 1 10 7 3 98\n"),
         "a.msh:18: element 1: there is no node with tag 98; tags are 3 to 99");
  expect(ErrorCode::kBadInput, msh22("1\n1 4 2 0 1 1 1 1 6\n", "$Nodes\n2\n1 0 0 0\n2 0 0 0\n$EndNodes\n"),
         "a.msh:15: element 1: vertex index 6 is out of range; valid are 1 to 2");
  expect(ErrorCode::kBadInput, msh22("0\n", "$Nodes\n2\n7 0 0 0\n7 0 0 0\n$EndNodes\n"),
         "node tag 7 stands twice");
  expect(ErrorCode::kBadInput, msh22("0\n", "$Nodes\n1\n7 0 nan 0\n$EndNodes\n"),
         "a.msh:10: node 1: coordinate y is nan");
  expect(ErrorCode::kUnsupported, msh22("1\n1 77 2 0 1 10\n"), "element type 77 is not known");
  expect(ErrorCode::kFormat, msh22("2\n1 4 2 0 1 10 7 3 99\n"),
         "a.msh:19: element 2: expected an element tag");
  expect(ErrorCode::kFormat, msh22("4000000000\n1 4 2 0 1 10 7 3 99\n"), "4000000000 elements are declared");
  expect(ErrorCode::kFormat, msh22("0\n", "$Nodes\n4000000000\n1 0 0 0\n$EndNodes\n"), "4000000000 nodes");
  expect(ErrorCode::kBadInput, msh22("0\n"), "no linear tetrahedra");
  expect(ErrorCode::kFormat, kHead22 + kNodes22.substr(0, 60), "a.msh:");
  expect(ErrorCode::kFormat, kHead22 + "Nodes\n", "a.msh:4: expected a section like $Nodes, found 'Nodes'");
  expect(ErrorCode::kFormat, kHead22 + "$Comment\n", "the section has no $EndComment");
}

TEST(Msh, NamesVersionsItDoesNotRead) {
  for (const char* version : {"1", "3.0", "4.0", "4.2"})
    expect_error(ErrorCode::kUnsupported, {"a.msh:2: version ", version, "save the mesh as 2.2 or 4.1"}, [&] {
      parse_msh(std::string("$MeshFormat\n") + version + " 0 8\n$EndMeshFormat\n", "a.msh");
    });
  expect_error(ErrorCode::kBadInput, {"a.msh", "empty"}, [] { parse_msh("", "a.msh"); });
  expect_error(ErrorCode::kFormat, {"expected a Gmsh file", "some other text"},
               [] { parse_msh("$NOD\n", "a.msh"); });
}

const std::string kBody41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$Entities\n1 1 1 2\n1 0 0 0 0\n1 0 0 0 1 1 1 0 2 1 -1\n5 0 0 0 1 1 1 1 12 1 1\n"
    "1 0 0 0 1 1 1 2 30 31 1 5\n2 0 0 0 1 1 1 0 1 -5\n$EndEntities\n"
    "$Nodes\n3 5 1 50\n0 1 0 1\n1\n0 0 0\n2 5 1 2\n20\n50\n0.1 0 0 0.5 0.5\n0 1 0 0.25 0.75\n"
    "3 1 0 2\n30\n31\n0 0 1\n1 1 1e-5\n$EndNodes\n";

TEST(Msh41, ReadsEntitiesParametersAndBlocks) {
  const TetMesh mesh = parse_msh(kBody41 +
                                     "$Elements\n4 4 1 9\n0 1 15 1\n1 1\n2 5 2 1\n2 1 20 50\n3 1 4 1\n8 1 20 "
                                     "50 30\n3 2 4 1\n9 20 50 30 31\n"
                                     "$EndElements\n",
                                 "a.msh");
  expect_same_points(mesh.points, {{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1e-5}});
  EXPECT_EQ(mesh.tets, (Tets{{0, 1, 2, 3}, {1, 2, 3, 4}}));
  EXPECT_EQ(mesh.regions, (Labels{30, 2}));
  EXPECT_EQ(mesh.triangle_labels, Labels{12});
}

TEST(Msh41, NamesFaults) {
  const auto expect = [](ErrorCode code, const std::string& elements, const std::string& fragment) {
    expect_error(code, {fragment},
                 [&] { parse_msh(kBody41 + "$Elements\n" + elements + "$EndElements\n", "a.msh"); });
  };
  expect(ErrorCode::kBadInput, "1 1 8 8\n3 1 4 1\n8 1 20 50 32\n",
         "a.msh:31: element 8: there is no node with tag 32; tags are 1 to 50");
  expect(ErrorCode::kFormat, "1 1 8 8\n3 1 4 9\n8 1 20 50 31\n",
         "expected an element tag (an integer), found '$End");
  expect_error(ErrorCode::kFormat, {"a.msh:6: node block 0: 100000000000 nodes are declared"}, [] {
    parse_msh(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 1 1 1\n3 1 0 100000000000\n1\n0 0 0\n$EndNodes\n",
        "a.msh");
  });
}

class MshBinary : public testing::TestWithParam<const char*> {};

TEST_P(MshBinary, RefusesEveryTruncation) {
  TemporaryFolder folder;
  write_tet_mesh(folder / "a.msh", sample_mesh(),
                 {.format = GetParam(), .ascii = false, .min_dihedral_deg = {}});
  const std::string bytes = get_file(folder / "a.msh");
  const std::size_t whole = bytes.rfind("$EndElements") + std::string_view("$EndElements").size();
  for (std::size_t size = 0; size < whole; ++size) {
    SCOPED_TRACE(size);
    EXPECT_THROW(parse_msh(std::string_view(bytes).substr(0, size), "a.msh"), Error);
  }
  EXPECT_EQ(parse_msh(std::string_view(bytes).substr(0, whole), "a.msh").tets.size(), 2u);
}

TEST_P(MshBinary, GivesTheByteOfAFault) {
  TemporaryFolder folder;
  TetMesh mesh = sample_mesh();
  mesh.points[0].x = 0.12345;
  write_tet_mesh(folder / "a.msh", mesh, {.format = GetParam(), .ascii = false, .min_dihedral_deg = {}});
  std::string bytes = get_file(folder / "a.msh");
  const double value = 0.12345, bad = std::numeric_limits<double>::infinity();
  const std::size_t at = bytes.rfind(std::string(reinterpret_cast<const char*>(&value), sizeof value));
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, sizeof bad, reinterpret_cast<const char*>(&bad), sizeof bad);
  expect_error(ErrorCode::kBadInput, {"a.msh: byte " + std::to_string(at) + ": ", "coordinate x is inf"},
               [&] { parse_msh(bytes, "a.msh"); });
}

INSTANTIATE_TEST_SUITE_P(Versions, MshBinary, testing::Values("msh22", "msh41"));

// The same file as a machine of the other byte order would write it.
TEST(Msh22, ReadsTheOtherByteOrder) {
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  const auto put = [&](auto value) {
    std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
    std::reverse(raw.begin(), raw.end());
    bytes += raw;
  };
  put(std::int32_t{1});
  bytes += "\n$EndMeshFormat\n$Nodes\n4\n";
  for (std::int32_t i = 1; i <= 4; ++i) {
    put(i);
    put(0.1 * i);
    put(i == 2 ? 1.0 : 0.0);
    put(i == 3 ? 1.0 : 0.0);
  }
  bytes += "\n$EndNodes\n$Elements\n1\n";
  for (const std::int32_t value : {4, 1, 2, 1, 5, 5, 1, 2, 3, 4}) put(value);
  bytes += "\n$EndElements\n";
  const TetMesh mesh = parse_msh(bytes, "a.msh");
  EXPECT_EQ(mesh.tets, (Tets{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.points[3].x, 0.1 * 4);
  EXPECT_EQ(mesh.regions, Labels{5});
}

}  // namespace
}  // namespace unsliver::io
