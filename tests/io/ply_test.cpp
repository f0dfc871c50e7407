#include <limits>

#include "io/readers.hpp"
#include "io/scanner.hpp"
#include "io_test_util.hpp"

namespace unsliver::io {
namespace {

using Triangles = std::vector<std::array<VertexId, 3>>;

std::string header(const std::string& format, const std::string& vertex_count = "4",
                   const std::string& face_count = "1") {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nobj_info none\nelement vertex " +
         vertex_count +
         "\nproperty float quality\nproperty double x\nproperty float y\nproperty double z\n"
         "property list uchar short rings\nelement material 1\nproperty int shade\nelement face " +
         face_count + "\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kTextVertices = "nan 0.1 0 -0 0\n0.5 1 0 0 2 7 8\n0.5 1 1 0 0\n0.5 0 0.25 1e-7 1 9\n-3\n";

TEST(Ply, ReadsText) {
  const TriangleMesh mesh = parse_ply(header("ascii") + kTextVertices + "255 4 0 1 2 3\n", "a.ply");
  expect_same_points(mesh.points, {{0.1, 0, -0.0}, {1, 0, 0}, {1, 1, 0}, {0, 0.25, 1e-7}});
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

/// Writes values in a chosen byte order.
class BinaryBody {
 public:
  explicit BinaryBody(std::endian order) : order_(order) {}
  template <class T>
  BinaryBody& operator<<(T value) {
    if (order_ != std::endian::native) value = byte_swapped(value);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  BinaryBody& vertex(double x, float y, double z) {
    return *this << 0.5f << x << y << z << std::uint8_t{2} << std::int16_t{7} << std::int16_t{8};
  }
  std::string bytes;

 private:
  std::endian order_;
};

BinaryBody square(std::endian order) {
  BinaryBody body(order);
  body.vertex(0.1, 0, -0.0).vertex(1, 0, 0).vertex(1, 1, 0).vertex(0, 0.25f, 1e-7);
  body << std::int32_t{-3};
  return body;
}

BinaryBody& quad(BinaryBody& body, std::int32_t last) {
  return body << std::uint8_t{255} << std::uint8_t{4} << std::int32_t{0} << std::int32_t{1} << std::int32_t{2}
              << last;
}

TEST(Ply, ReadsBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const char* format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    SCOPED_TRACE(format);
    BinaryBody body = square(order);
    const TriangleMesh mesh = parse_ply(header(format) + quad(body, 3).bytes, "a.ply");
    expect_same_points(mesh.points, {{0.1, 0, -0.0}, {1, 0, 0}, {1, 1, 0}, {0, 0.25, 1e-7}});
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  }
}

TEST(Ply, ReadsEveryTypeName) {
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8",
                           "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"}) {
    SCOPED_TRACE(type);
    const std::string text = std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty ") + type +
                             " x\nproperty float y\nproperty float z\nelement face 1\nproperty list " + type +
                             " " + type + " vertex_index\nend_header\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n";
    EXPECT_EQ(parse_ply(text, "a.ply").triangles, (Triangles{{0, 1, 2}}));
  }
}

TEST(Ply, NamesTheIndexOutOfRange) {
  expect_error(ErrorCode::kBadInput, {"a.ply:22: face 0: vertex index 4 is out of range; valid are 0 to 3"},
               [] { parse_ply(header("ascii") + kTextVertices + "255 4 0 1 2 4\n", "a.ply"); });
  BinaryBody body = square(std::endian::little);
  const std::string bytes = header("binary_little_endian") + quad(body, -1).bytes;
  expect_error(
      ErrorCode::kBadInput,
      {"a.ply: byte " + std::to_string(bytes.size() - 4) + ": face 0: vertex index -1 is out of range"},
      [&] { parse_ply(bytes, "a.ply"); });
}

TEST(Ply, RefusesWhatIsNotFinite) {
  BinaryBody body(std::endian::little);
  body.vertex(0, 0, std::numeric_limits<double>::infinity()).vertex(0, 0, 0).vertex(0, 0, 0).vertex(0, 0, 0);
  expect_error(ErrorCode::kBadInput, {"vertex 0: a coordinate is inf"},
               [&] { parse_ply(header("binary_little_endian") + body.bytes, "a.ply"); });
}

TEST(Ply, RefusesEveryTruncation) {
  BinaryBody body = square(std::endian::little);
  const std::string head = header("binary_little_endian");
  const std::string binary = head + quad(body, 3).bytes;
  for (std::size_t size = head.size(); size < binary.size(); ++size) {
    SCOPED_TRACE(size);
    expect_error(ErrorCode::kFormat, {"a.ply: byte "},
                 [&] { parse_ply(std::string_view(binary).substr(0, size), "a.ply"); });
  }
  const std::string text = header("ascii") + kTextVertices + "255 4 0 1 2 3";
  for (std::size_t size = 0; size < text.size(); ++size) {
    SCOPED_TRACE(size);
    EXPECT_THROW(parse_ply(std::string_view(text).substr(0, size), "a.ply"), Error);
  }
}

TEST(Ply, ChecksCountsBeforeTakingMemory) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    SCOPED_TRACE(format);
    expect_error(ErrorCode::kFormat, {"4000000000 vertex are declared"},
                 [&] { parse_ply(header(format, "4000000000") + kTextVertices, "a.ply"); });
  }
  expect_error(ErrorCode::kFormat, {"4000000000 face are declared"},
               [&] { parse_ply(header("ascii", "4", "4000000000") + kTextVertices, "a.ply"); });
  expect_error(ErrorCode::kFormat, {"face 0: 2000000000 list entries are declared"},
               [&] { parse_ply(header("ascii") + kTextVertices + "255 2000000000 0 1 2\n", "a.ply"); });
}

TEST(Ply, RefusesBrokenHeaders) {
  const auto with = [](const std::string& lines) {
    return "ply\nformat ascii 1.0\n" + lines + "end_header\n";
  };
  expect_error(ErrorCode::kFormat, {"a.ply:4: 'quad' is not a type of PLY"},
               [&] { parse_ply(with("element vertex 1\nproperty quad x\n"), "a.ply"); });
  expect_error(ErrorCode::kFormat, {"a.ply:3: unknown header line 'elephant'"},
               [&] { parse_ply(with("elephant\n"), "a.ply"); });
  expect_error(ErrorCode::kFormat, {"a.ply:3: a property stands before any element"},
               [&] { parse_ply(with("property float x\n"), "a.ply"); });
  expect_error(ErrorCode::kFormat, {"no property 'y'"}, [&] {
    parse_ply(
        with("element vertex 1\nproperty float x\nelement face 1\nproperty list uchar int vertex_index\n"),
        "a.ply");
  });
  expect_error(ErrorCode::kFormat, {"no format line"}, [] { parse_ply("ply\nend_header\n", "a.ply"); });
  expect_error(ErrorCode::kFormat, {"a.ply:2: the format must be"},
               [] { parse_ply("ply\nformat utf8 1.0\nend_header\n", "a.ply"); });
}

TEST(Ply, RefusesFilesWithoutASurface) {
  expect_error(ErrorCode::kBadInput, {"no vertices or no faces"},
               [] { parse_ply("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "a.ply"); });
  expect_error(ErrorCode::kBadInput, {"no triangles"},
               [] { parse_ply(header("ascii", "4", "0") + kTextVertices, "a.ply"); });
  expect_error(ErrorCode::kUnsupported, {"triangle strips"},
               [] { parse_ply("ply\nformat ascii 1.0\nelement tristrips 1\nend_header\n", "a.ply"); });
  expect_error(ErrorCode::kBadInput, {"empty"}, [] { parse_ply("", "a.ply"); });
  expect_error(ErrorCode::kFormat, {"expected a PLY file"}, [] { parse_ply("solid x", "a.ply"); });
}

}  // namespace
}  // namespace unsliver::io
