#include <cmath>
#include <cstring>
#include <random>

#include "io/readers.hpp"
#include "io/vtu_document.hpp"
#include "io/vtu_values.hpp"
#include "io/zlib_blocks.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

// The fixtures hold one tetrahedron (region 4) and one triangle (region 9), as other programs write them.
const std::vector<Vec3> kPoints{{0.1, 0, 0}, {1.0 / 3.0, 0, 0}, {0, 1, 0}, {0, 0, 1e-300}};

void expect_fixture(const TetMesh& mesh) {
  expect_same_points(mesh.points, kPoints);
  EXPECT_EQ(mesh.tets, (std::vector<std::array<VertexId, 4>>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<VertexId, 3>>{{0, 2, 1}}));
  EXPECT_EQ(mesh.regions, std::vector<std::int32_t>{4});
  EXPECT_EQ(mesh.triangle_labels, std::vector<std::int32_t>{9});
}

struct Arrays {
  std::string points, connectivity, offsets, types, region;
};

std::string inline_vtu(const std::string& root_attributes, const std::string& format, const Arrays& arrays) {
  const auto array = [&](const char* type, const char* name, const std::string& text) {
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
           "\" NumberOfComponents='3' format=\"" + format + "\">\n" + text + "\n</DataArray>\n";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" " + root_attributes +
         ">\n<!-- > by hand -->\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" "
         "NumberOfCells=\"2\">\n<Points>\n" +
         array("Float64", "Points", arrays.points) + "</Points>\n<Cells>\n" +
         array("Int64", "connectivity", arrays.connectivity) + array("Int64", "offsets", arrays.offsets) +
         array("Int64", "types", arrays.types) + "</Cells>\n<CellData>\n" +
         array("Int64", "region", arrays.region) + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

const Arrays kText{"0.1 0 0\n0.3333333333333333 0 0\n0 1 0\n0 0 1e-300", "0 1 2 3\n0 2 1", "4 7", "10 5",
                   "4\n9"};

const Arrays kPlainBase64{
    "YAAAAJqZmZmZmbk/AAAAAAAAAAAAAAAAAAAAAFVVVVVVVdU/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAAAAAAAA"
    "AAAAAAAAAAAAAAAAAABZ8/jCH26lAQ==",
    "OAAAAAAAAAAAAAAAAQAAAAAAAAACAAAAAAAAAAMAAAAAAAAAAAAAAAAAAAACAAAAAAAAAAEAAAAAAAAA",
    "EAAAAAQAAAAAAAAABwAAAAAAAAA=", "EAAAAAoAAAAAAAAABQAAAAAAAAA=", "EAAAAAQAAAAAAAAACQAAAAAAAAA="};

const Arrays kZlibBase64{
    "AQAAAAAAAAAAgAAAAAAAAGAAAAAAAAAAIwAAAAAAAAA=eJybNRMEdtozoIFQMLiKIY4KPuCUj/z845B83lJGALaNDQo=",
    "AQAAAAAAAAAAgAAAAAAAADgAAAAAAAAAFwAAAAAAAAA=eJxjYIAARijNBKWZGVABE5o6AAFAAAo=",
    "AQAAAAAAAAAAgAAAAAAAABAAAAAAAAAADgAAAAAAAAA=eJxjYYAAdigNAACIAAw=",
    "AQAAAAAAAAAAgAAAAAAAABAAAAAAAAAADgAAAAAAAAA=eJzjYoAAVigNAADYABA=",
    "AQAAAAAAAAAAgAAAAAAAABAAAAAAAAAADgAAAAAAAAA=eJxjYYAATigNAACYAA4="};

const std::string kZlibRoot =
    "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"";

// Big endian, 32-bit headers, zlib, appended base64.
std::string appended_vtu() {
  return R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="BigEndian" header_type="UInt32" compressor="vtkZLibDataCompressor">
  <UnstructuredGrid>
    <Piece NumberOfPoints="4"                    NumberOfCells="2"                   >
      <PointData>
      </PointData>
      <CellData>
        <DataArray type="Int64" Name="region" format="appended" RangeMin="4" RangeMax="9" offset="0"/>
      </CellData>
      <Points>
        <DataArray type="Float64" Name="Points" NumberOfComponents="3" format="appended" offset="48"   />
      </Points>
      <Cells>
        <DataArray type="Int64" Name="connectivity" format="appended" RangeMin="" RangeMax="" offset="124"/>
        <DataArray type="Int64" Name="offsets" format="appended" offset="180"/>
        <DataArray type="UInt8" Name="types" format="appended" offset="228"/>
      </Cells>
    </Piece>
  </UnstructuredGrid>
  <AppendedData encoding="base64">
   _AAAAAQAAgAAAAAAQAAAAEA==eF5jYAADFgjFwAkAAD0ADg==AAAAAQAAgAAAAABgAAAAJg==eF6z3zkTBGYxoAH7q6FggC4Ol/+ASwYCGJfmyR/68TkSALbQDQo=AAAAAQAAgAAAAAA4AAAAFg==eF5jYEABjFCaCUozo0rDxRkBAQEACg==AAAAAQAAgAAAAAAQAAAAEA==eF5jYAADFgjFwA4AADsADA==AAAAAQAAgAAAAAACAAAACg==eF7jYgUAABsAEA==
  </AppendedData>
</VTKFile>
)";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Vtu, ReadsInlineText) { expect_fixture(parse_vtu(inline_vtu("", "ascii", kText), "a.vtu")); }

TEST(Vtu, ReadsInlineBase64) {
  expect_fixture(parse_vtu(inline_vtu("byte_order=\"LittleEndian\"", "binary", kPlainBase64), "a.vtu"));
}

TEST(Vtu, ReadsInlineBase64WithZlib) {
  expect_fixture(parse_vtu(inline_vtu(kZlibRoot, "binary", kZlibBase64), "a.vtu"));
}

TEST(Vtu, ReadsAppendedBase64InBigEndian) { expect_fixture(parse_vtu(appended_vtu(), "a.vtu")); }

TEST(Vtu, JoinsPieces) {
  const std::string one = inline_vtu("", "ascii", kText);
  const std::size_t begin = one.find("<Piece"), end = one.find("</UnstructuredGrid>");
  const TetMesh mesh = parse_vtu(one.substr(0, end) + one.substr(begin), "a.vtu");
  EXPECT_EQ(mesh.points.size(), 8u);
  EXPECT_EQ(mesh.tets, (std::vector<std::array<VertexId, 4>>{{0, 1, 2, 3}, {4, 5, 6, 7}}));
  EXPECT_EQ(mesh.regions, (std::vector<std::int32_t>{4, 4}));
}

TEST(Vtu, SkipsOtherCells) {
  Arrays arrays = kText;
  arrays.types = "10 7";
  EXPECT_TRUE(parse_vtu(inline_vtu("", "ascii", arrays), "a.vtu").triangles.empty());
  arrays.types = "7 5";
  expect_error(ErrorCode::kBadInput, {"a.vtu", "no linear tetrahedra"},
               [&] { parse_vtu(inline_vtu("", "ascii", arrays), "a.vtu"); });
}

TEST(Vtu, NamesTheIndexOutOfRange) {
  Arrays arrays = kText;
  arrays.connectivity = "0 1 2 4 0 2 1";
  expect_error(ErrorCode::kBadInput, {"a.vtu: cell 0 uses point 4; valid are 0 to 3"},
               [&] { parse_vtu(inline_vtu("", "ascii", arrays), "a.vtu"); });
  arrays.connectivity = "0 1 2 3 0 -2 1";
  expect_error(ErrorCode::kBadInput, {"cell 1 uses point -2"},
               [&] { parse_vtu(inline_vtu("", "ascii", arrays), "a.vtu"); });
}

TEST(Vtu, RefusesInconsistentArrays) {
  const auto expect = [](Arrays arrays, const std::string& fragment) {
    expect_error(ErrorCode::kFormat, {"a.vtu", fragment},
                 [&] { parse_vtu(inline_vtu("", "ascii", arrays), "a.vtu"); });
  };
  Arrays arrays = kText;
  arrays.offsets = "4 8";
  expect(arrays, "the offset of cell 1 is 8; valid are 4 to 7");
  arrays.offsets = "4 3";
  expect(arrays, "the offset of cell 1 is 3");
  arrays.offsets = "3 7";
  expect(arrays, "cell 0 has 3 points, but its type needs 4");
  arrays.offsets = "4";
  expect(arrays, "2 cells are declared, but 1 offsets");
  arrays = kText;
  arrays.points = "1 2 3";
  expect(arrays, "4 points are declared, but 3 coordinates");
  arrays.points = "0 0 0\n1 0 0\n0 one 0\n0 0 1";
  expect(arrays, "array 'Points', its line:4: expected a value (a number), found 'one'");
}

TEST(Vtu, RefusesWhatIsNotFinite) {
  Arrays arrays = kText;
  arrays.points = "0 0 0\n1 0 0\n0 nan 0\n0 0 1";
  expect_error(ErrorCode::kBadInput, {"a.vtu: array 'Points', its line:4: a value is nan"},
               [&] { parse_vtu(inline_vtu("", "ascii", arrays), "a.vtu"); });
  // The last of the three doubles is infinity.
  const std::string infinite = "GAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwfw==";
  std::string text = inline_vtu("", "binary", {infinite, "", "", "", ""});
  text = replaced(text, "NumberOfPoints=\"4\"", "NumberOfPoints=\"1\"");
  expect_error(ErrorCode::kBadInput, {"point 0 is (0, 0, inf)"}, [&] { parse_vtu(text, "a.vtu"); });
}

TEST(Vtu, RefusesDamagedData) {
  Arrays arrays = kZlibBase64;
  arrays.points[60] = arrays.points[60] == 'A' ? 'B' : 'A';
  expect_error(ErrorCode::kFormat, {"array 'Points' of Points: a compressed block is damaged"},
               [&] { parse_vtu(inline_vtu(kZlibRoot, "binary", arrays), "a.vtu"); });
  arrays.points = kZlibBase64.points.substr(0, 64);
  expect_error(ErrorCode::kFormat, {"array 'Points' of Points", "truncated"},
               [&] { parse_vtu(inline_vtu(kZlibRoot, "binary", arrays), "a.vtu"); });
  arrays.points = "AQAA*A";
  expect_error(ErrorCode::kFormat, {"not base64"},
               [&] { parse_vtu(inline_vtu(kZlibRoot, "binary", arrays), "a.vtu"); });
  // Header: 2^32 - 1 blocks of 2^32 - 1 bytes.
  arrays.points = "/////wAAAAD/////AAAAAAAAAAAAAAAA";
  expect_error(ErrorCode::kFormat, {"declares more data than the file can hold"},
               [&] { parse_vtu(inline_vtu(kZlibRoot, "binary", arrays), "a.vtu"); });
}

TEST(Vtu, RefusesBrokenStructure) {
  const std::string good = appended_vtu();
  const auto expect = [](ErrorCode code, const std::string& text, const std::string& fragment) {
    expect_error(code, {fragment}, [&] { parse_vtu(text, "a.vtu"); });
  };
  expect(ErrorCode::kUnsupported, replaced(good, "\"UnstructuredGrid\"", "\"PolyData\""), "type 'PolyData'");
  expect(ErrorCode::kUnsupported, replaced(good, "vtkZLib", "vtkLZ4"), "compressor 'vtkLZ4DataCompressor'");
  expect(ErrorCode::kFormat, replaced(good, "\"connectivity\"", "\"con\""),
         "no array 'connectivity' in Cells");
  expect(ErrorCode::kFormat, replaced(good, "\"Int64\"", "\"Int65\""), "its type 'Int65' is unknown");
  expect(ErrorCode::kFormat, replaced(good, "_AAAA", "AAAA"), "a.vtu:20: the appended data does not start");
  expect(ErrorCode::kFormat, replaced(good, "offset=\"48\"", "offset=\"999999\""),
         "outside the appended data");
  expect(ErrorCode::kFormat, replaced(good, "offset=\"48\"", "offset=\"x\""), "a.vtu:11: attribute 'offset'");
  expect(ErrorCode::kFormat, replaced(good, "NumberOfPoints=\"4\"", "NumberOfPoints=4"), "a.vtu:4: ");
  const std::string text = inline_vtu("", "ascii", kText);
  expect(ErrorCode::kFormat, text.substr(0, text.find("</VTKFile")), "truncated");
  expect(ErrorCode::kBadInput, "", "a.vtu: the file is empty; expected a VTU file");
  expect(ErrorCode::kFormat, "$MeshFormat\n", "a Gmsh mesh");
}

TEST(Vtu, WritesWhatIsGivenForTetrahedra) {
  TemporaryFolder folder;
  WriteOptions options;
  options.min_dihedral_deg = {30.5f, 60};
  write_tet_mesh(folder / "a.vtu", sample_mesh(), options);
  const std::string bytes = get_file(folder / "a.vtu");
  const VtuDocument document = parse_vtu_document(bytes, "a.vtu");
  ASSERT_EQ(document.pieces.size(), 1u);
  const VtuArray* array = document.pieces[0].find("CellData", "min_dihedral");
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->type, "Float32");
  const std::vector<double> values = vtu_values<double>(document, *array);
  ASSERT_EQ(values.size(), 5u);
  EXPECT_EQ(values[0], 30.5);
  EXPECT_EQ(values[1], 60);
  for (int triangle = 2; triangle < 5; ++triangle) EXPECT_TRUE(std::isnan(values[triangle]));
}

TEST(Vtu, LimitsComeBack) {
  TemporaryFolder folder;
  const QualityLimits kLimits[] = {{30, 135, 1.118033988749895}, {10.5, 155.25, 1.368}, {}};
  for (const QualityLimits& limits : kLimits)
    for (const bool with_frame : {true, false}) {
      TetMesh mesh = sample_mesh();
      mesh.limits = limits;
      if (!with_frame) mesh.frame.reset();
      write_tet_mesh(folder / "a.vtu", mesh);
      const TetMesh back = read_tet_mesh(folder / "a.vtu");
      EXPECT_EQ(back.limits, limits);
      EXPECT_EQ(back.frame.has_value(), with_frame);
    }
  write_tet_mesh(folder / "a.vtu", sample_mesh());
  EXPECT_FALSE(read_tet_mesh(folder / "a.vtu").limits);
}

TEST(Vtu, RefusesLimitsThatAreNone) {
  const auto with = [](const std::string& values) {
    return replaced(inline_vtu("", "ascii", kText), "<Piece",
                    "<FieldData><DataArray type=\"Float64\" Name=\"unsliver_limits\" format=\"ascii\">" +
                        values + "</DataArray></FieldData>\n<Piece");
  };
  EXPECT_EQ(parse_vtu(with("20 145 1.5"), "a.vtu").limits, (QualityLimits{20, 145, 1.5}));
  for (const char* values : {"", "20", "20 145", "20 145 1.5 2", "-1 145 1.5", "20 181 1.5", "145 20 1.5",
                             "20 145 0", "20 145 -1.5"}) {
    SCOPED_TRACE(values);
    expect_error(ErrorCode::kBadInput, {"a.vtu", "unsliver_limits", "radius-edge"},
                 [&] { parse_vtu(with(values), "a.vtu"); });
  }
  for (const char* values : {"nan 145 1.5", "20 inf 1.5", "20 145 one"}) {
    SCOPED_TRACE(values);
    EXPECT_THROW(parse_vtu(with(values), "a.vtu"), Error);
  }
}

// Long enough for several blocks in each array.
TEST(Vtu, LargeMeshesComeBack) {
  TemporaryFolder folder;
  std::mt19937_64 bits(7);
  TetMesh mesh;
  for (std::uint32_t i = 0; i < 60000; ++i) mesh.points.push_back({0.5 * i, double(bits() % 1000), 1e-3 * i});
  for (std::uint32_t i = 0; i < 290000; ++i) {
    const auto near = [&] { return VertexId(i / 5 + bits() % 300); };
    mesh.tets.push_back({near(), near(), near(), near()});
  }
  const auto expect_back = [&] {
    write_tet_mesh(folder / "a.vtu", mesh);
    const TetMesh back = read_tet_mesh(folder / "a.vtu");
    EXPECT_EQ(back.points, mesh.points);
    EXPECT_EQ(back.tets, mesh.tets);
    EXPECT_EQ(back.triangles, mesh.triangles);
  };
  expect_back();
  for (std::uint32_t i = 0; i < 90000; ++i) mesh.triangles.push_back({i / 2, i / 2 + 1, i / 2 + 9});
  expect_back();
}

// The header of a compressed array, and the streams behind it.
void expect_blocks(const std::string& blocks, const std::string& data) {
  const std::size_t kBlock = 32 * 32768, count = (data.size() + kBlock - 1) / kBlock;
  const auto header = [&](std::size_t i) {
    std::uint64_t value;
    std::memcpy(&value, blocks.data() + 8 * i, 8);
    return value;
  };
  EXPECT_EQ(header(0), count);
  EXPECT_EQ(header(1), kBlock);
  EXPECT_EQ(header(2), data.size() % kBlock);
  std::size_t position = 8 * (3 + count);
  for (std::size_t block = 0; block < count; ++block) {
    std::string out(std::min(kBlock, data.size() - block * kBlock), '\0');
    ASSERT_TRUE(decompress_block(std::string_view(blocks).substr(position, header(3 + block)), out.data(),
                                 out.size()));
    EXPECT_EQ(out, data.substr(block * kBlock, kBlock));
    position += header(3 + block);
  }
  EXPECT_EQ(position, blocks.size());
}

TEST(ZlibBlocks, HeaderFollowsVtk) {
  const std::size_t kBlock = 32 * 32768;
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, kBlock - 1, kBlock, kBlock + 1, 3 * kBlock}) {
    SCOPED_TRACE(size);
    std::string data(size, '\0');
    for (std::size_t i = 0; i < size; ++i) data[i] = static_cast<char>(i * i >> 7);
    expect_blocks(compress_blocks(data), data);
  }
}

// A changed bit that no reader looks at may pass, but other data never does.
TEST(ZlibBlocks, DamagedStreamsAreRefused) {
  const std::size_t kHeader = 4 * 8;
  std::string data(3000, '\0'), out(data.size() + 1, '\0');
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<char>(i * i >> 7);
  const std::string stream = compress_blocks(data).substr(kHeader);
  ASSERT_TRUE(decompress_block(stream, out.data(), data.size()));
  EXPECT_FALSE(decompress_block(stream, out.data(), data.size() - 1));
  EXPECT_FALSE(decompress_block(stream, out.data(), data.size() + 1));
  for (std::size_t size = 0; size < stream.size(); ++size)
    EXPECT_FALSE(decompress_block(stream.substr(0, size), out.data(), data.size())) << size;
  for (std::size_t bit = 0; bit < 8 * stream.size(); ++bit) {
    std::string damaged = stream;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
    const bool read = decompress_block(damaged, out.data(), data.size());
    EXPECT_TRUE(!read || out.substr(0, data.size()) == data) << bit;
  }
}

}  // namespace
}  // namespace unsliver::io
