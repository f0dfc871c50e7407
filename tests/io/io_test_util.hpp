/// \file
/// What the io tests share: a folder that cleans up, sample meshes, and checks of errors.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "unsliver/error.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// A new folder of this test, removed with all its content at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string stem = std::string("unsliver_io_") + test->test_suite_name() + "_" + test->name();
    for (int i = 0;; ++i) {
      std::string name = stem + std::to_string(i);
      for (char& c : name)
        if (c == '/') c = '_';
      path_ = std::filesystem::temp_directory_path() / name;
      if (std::filesystem::create_directory(path_)) break;
    }
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  /// The names in the folder, sorted.
  std::vector<std::string> list() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

inline void put_file(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string get_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Expects that `act` throws an Error of that code whose message has each of the fragments.
template <class Act>
void expect_error(ErrorCode code, const std::vector<std::string>& fragments, const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_STREQ(to_string(error.code()), to_string(code)) << error.what();
    for (const std::string& fragment : fragments)
      EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos)
          << "'" << fragment << "' is missing in: " << error.what();
    return;
  }
  ADD_FAILURE() << "no error; expected " << to_string(code);
}

/// Equal bit for bit: tells -0 from 0.
inline void expect_same_points(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i][axis]), std::bit_cast<std::uint64_t>(b[i][axis]))
          << "point " << i << ", axis " << axis << ": " << a[i][axis] << " and " << b[i][axis];
}

/// Two tetrahedra on five points with coordinates that are hard to write, all arrays filled.
inline TetMesh sample_mesh() {
  TetMesh mesh;
  mesh.points = {{0.1, -0.0, 1.0 / 3.0},
                 {1e22, 5e-324, -2.2250738585072014e-308},
                 {123456789.12345678, 9007199254740993.0, -1e-17},
                 {1.7976931348623157e308, 0.30000000000000004, 2},
                 {-7, 8, 9.999999999999998}};
  mesh.tets = {{0, 1, 2, 3}, {4, 2, 1, 3}};
  mesh.regions = {3, -7};
  mesh.levels = {0, 1, 2, 3, 255};
  mesh.point_source = {2, -1, 0, 1, std::int64_t{1} << 40};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 3, 1}};
  mesh.triangle_labels = {1, 12, 1};
  mesh.frame = Frame{64.0 / 1024, {1e6, -2e6, 0.0625}};
  return mesh;
}

}  // namespace unsliver::io
