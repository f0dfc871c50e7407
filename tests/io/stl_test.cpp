#include <random>

#include "io/point_merger.hpp"
#include "io/readers.hpp"
#include "io_test_util.hpp"

namespace unsliver::io {
namespace {

constexpr const char* kFacet =
    "facet normal nan nan nan\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 0.1 0\n "
    "endloop\nendfacet\n";

std::string ascii_stl() {
  return std::string("solid two words\n") + kFacet + kFacet + "endsolid two words\n";
}

void append(std::string& bytes, const auto& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

using FloatTriangle = std::array<std::array<float, 3>, 3>;
constexpr FloatTriangle kLower{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
constexpr FloatTriangle kUpper{{{1, 0, 0}, {1, 1, 0.1f}, {0, 1, 0}}};

std::string binary_stl(const std::vector<FloatTriangle>& triangles, std::string_view header = "") {
  std::string bytes(header);
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles.size()));
  for (const FloatTriangle& triangle : triangles) {
    append(bytes, std::array<float, 3>{});
    append(bytes, triangle);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

TEST(Stl, ReadsTextAndMergesCorners) {
  const TriangleMesh mesh = parse_stl(ascii_stl(), "a.stl");
  expect_same_points(mesh.points, {{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}});
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<VertexId, 3>>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_EQ(mesh.name, "a.stl");
}

TEST(Stl, ReadsTextInAnyCaseWithSeveralSolidsOrNone) {
  std::string upper = ascii_stl() + ascii_stl();
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  EXPECT_EQ(parse_stl(upper, "a.stl").triangles.size(), 4u);
  EXPECT_EQ(parse_stl(kFacet, "a.stl").triangles.size(), 1u);
  EXPECT_EQ(parse_stl("  \r\n" + ascii_stl(), "a.stl").triangles.size(), 2u);
}

TEST(Stl, ReadsBinary) {
  const TriangleMesh mesh = parse_stl(binary_stl({kLower, kUpper}), "b.stl");
  expect_same_points(mesh.points, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, double{0.1f}}});
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<VertexId, 3>>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(Stl, ReadsBinaryThatStartsLikeText) {
  EXPECT_EQ(parse_stl(binary_stl({kLower, kUpper}, "solid exported"), "b.stl").triangles.size(), 2u);
  EXPECT_EQ(parse_stl(binary_stl({kLower, kUpper}, "facet"), "b.stl").triangles.size(), 2u);
}

TEST(Stl, RefusesTruncatedBinary) {
  for (const char* header : {"", "solid exported"}) {
    const std::string bytes = binary_stl({kLower, kUpper}, header);
    for (std::size_t size = 84; size < bytes.size(); ++size) {
      SCOPED_TRACE(size);
      expect_error(ErrorCode::kFormat, {"b.stl: byte 80: 2 facets of 50 bytes are declared"},
                   [&] { parse_stl(std::string_view(bytes).substr(0, size), "b.stl"); });
    }
  }
}

TEST(Stl, RefusesDeclaredFacetsThatCannotBeThere) {
  std::string bytes = binary_stl({kLower});
  bytes[80] = bytes[81] = bytes[82] = bytes[83] = '\xff';
  expect_error(ErrorCode::kFormat, {"4294967295 facets"}, [&] { parse_stl(bytes, "b.stl"); });
}

TEST(Stl, RefusesTruncatedText) {
  const std::string text = ascii_stl();
  const std::size_t start = text.find("facet"), end = text.rfind("endsolid");
  for (std::size_t size = start; size < end + 8; ++size) {
    SCOPED_TRACE(size);
    expect_error(ErrorCode::kFormat, {"a.stl:"}, [&] { parse_stl(text.substr(0, size), "a.stl"); });
  }
}

TEST(Stl, RefusesWhatIsNotFinite) {
  FloatTriangle bad = kLower;
  bad[1][2] = std::numeric_limits<float>::quiet_NaN();
  expect_error(ErrorCode::kBadInput, {"b.stl: byte 166: facet 1: a coordinate is nan"}, [&] {
    parse_stl(binary_stl({kLower, bad}), "b.stl");
  });
  std::string text = ascii_stl();
  text.replace(text.find("0.1"), 3, "inf");
  expect_error(ErrorCode::kBadInput, {"a.stl:6: facet 0: coordinate y is inf"},
               [&] { parse_stl(text, "a.stl"); });
}

TEST(Stl, RefusesBrokenText) {
  std::string text = ascii_stl();
  text.replace(text.find("endloop"), 7, "vertex ");
  expect_error(ErrorCode::kFormat, {"a.stl:7: facet 0: expected 'endloop', found 'vertex'"},
               [&] { parse_stl(text, "a.stl"); });
}

TEST(Stl, RefusesFilesWithoutTriangles) {
  expect_error(ErrorCode::kBadInput, {"no triangles"}, [] { parse_stl("solid x\nendsolid x\n", "a.stl"); });
  expect_error(ErrorCode::kBadInput, {"no triangles"}, [] { parse_stl(binary_stl({}), "b.stl"); });
  expect_error(ErrorCode::kBadInput, {"a.stl", "empty"}, [] { parse_stl("", "a.stl"); });
  expect_error(ErrorCode::kFormat, {"a.stl", "expected an STL file", "an OFF file"},
               [] { parse_stl("OFF\n1 2 3\n", "a.stl"); });
}

TEST(PointMerger, EqualNumbersAreOnePoint) {
  PointMerger merger;
  EXPECT_EQ(merger.add({0.0, 1, 2}), 0u);
  EXPECT_EQ(merger.add({1.0, 0, 2}), 1u);
  EXPECT_EQ(merger.add({-0.0, 1, 2}), 0u);
  EXPECT_EQ(merger.add({std::nextafter(0.0, 1.0), 1, 2}), 2u);
}

TEST(PointMerger, AgreesWithLinearSearch) {
  std::mt19937_64 random(7);
  PointMerger merger;
  std::vector<Vec3> seen;
  for (int i = 0; i < 3000; ++i) {
    const auto draw = [&] { return static_cast<double>(random() % 8) / 8; };
    const Vec3 p{draw(), draw(), draw()};
    const auto found = std::find(seen.begin(), seen.end(), p);
    const auto expected = static_cast<VertexId>(found - seen.begin());
    if (found == seen.end()) seen.push_back(p);
    ASSERT_EQ(merger.add(p), expected);
  }
  expect_same_points(merger.take_points(), seen);
}

}  // namespace
}  // namespace unsliver::io
