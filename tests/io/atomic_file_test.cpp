#include "io/atomic_file.hpp"

#include <sys/resource.h>

#include <csignal>

#include "io/output.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

/// Lets no file grow beyond a size, as a full disk would.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t size) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{size, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  void (*old_handler_)(int);
  rlimit old_{};
};

TetMesh large_mesh() {
  TetMesh mesh = sample_mesh();
  mesh = TetMesh{mesh.points, {}, {}, {}, {}, {}, {}, {}};
  for (VertexId i = 0; i < 20000; ++i) mesh.tets.push_back({i % 5, (i + i / 5) % 5, i / 7 % 5, i / 11 % 5});
  return mesh;
}

TEST(AtomicFile, AppearsOnlyAtCommit) {
  TemporaryFolder folder;
  put_file(folder / "a", "old");
  {
    AtomicFile file(folder / "a");
    file.write("new");
    EXPECT_EQ(get_file(folder / "a"), "old");
    EXPECT_EQ(folder.list().size(), 2u);
    file.commit();
  }
  EXPECT_EQ(get_file(folder / "a"), "new");
  EXPECT_EQ(folder.list(), std::vector<std::string>{"a"});
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  TemporaryFolder folder;
  put_file(folder / "a", "old");
  { AtomicFile(folder / "a").write("new"); }
  { AtomicFile(folder / "b").write("new"); }
  EXPECT_EQ(get_file(folder / "a"), "old");
  EXPECT_EQ(folder.list(), std::vector<std::string>{"a"});
}

TEST(AtomicFile, TwoWritersOfOneNameDoNotMix) {
  TemporaryFolder folder;
  AtomicFile first(folder / "a"), second(folder / "a");
  first.write("first");
  second.write("second");
  second.commit();
  EXPECT_EQ(get_file(folder / "a"), "second");
  first.commit();
  EXPECT_EQ(get_file(folder / "a"), "first");
  EXPECT_EQ(folder.list(), std::vector<std::string>{"a"});
}

TEST(AtomicFile, FollowsLinksAndKeepsPermissions) {
  TemporaryFolder folder;
  namespace fs = std::filesystem;
  put_file(folder / "target", "old");
  fs::permissions(folder / "target", fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_write);
  const fs::perms before = fs::status(folder / "target").permissions();
  fs::create_symlink("target", folder / "link");
  AtomicFile file(folder / "link");
  file.write("new");
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(get_file(folder / "target"), "new");
  EXPECT_EQ(fs::status(folder / "target").permissions(), before);
}

TEST(AtomicFile, RefusesFoldersAndMissingFolders) {
  TemporaryFolder folder;
  expect_error(ErrorCode::kIo, {"cannot write", "missing", "No such file"},
               [&] { AtomicFile(folder / "missing/a.vtu"); });
  std::filesystem::create_directory(folder / "a.vtu");
  expect_error(ErrorCode::kIo, {"cannot write", "a.vtu", "directory"}, [&] { AtomicFile(folder / "a.vtu"); });
  EXPECT_EQ(folder.list(), std::vector<std::string>{"a.vtu"});
}

TEST(AtomicFile, RefusesAFileAsFolder) {
  TemporaryFolder folder;
  put_file(folder / "file", "x");
  expect_error(ErrorCode::kIo, {"cannot write", "Not a directory"},
               [&] { AtomicFile(folder / "file/a.vtu"); });
}

TEST(Output, PutsTheShortestTextThatReadsBack) {
  TemporaryFolder folder;
  Output out(folder / "a");
  out.print(0.1, " ", 1e22, " ", -0.0, " ", 5e-324, " ", 0.1f, " ", -7, " ", std::uint64_t{1} << 63);
  out.commit();
  EXPECT_EQ(get_file(folder / "a"), "0.1 1e+22 -0 5e-324 0.1 -7 9223372036854775808");
}

class WriterFailure : public testing::TestWithParam<const char*> {};

TEST_P(WriterFailure, FullDiskLeavesTheOldFile) {
  TemporaryFolder folder;
  const auto path = folder / GetParam();
  put_file(path, "old");
  {
    const FileSizeLimit limit(1000);
    expect_error(ErrorCode::kIo, {"cannot write", (folder / "a.").string(), "File too large"},
                 [&] { write_tet_mesh(path, large_mesh()); });
  }
  EXPECT_EQ(get_file(path), "old");
  EXPECT_EQ(folder.list(), std::vector<std::string>{GetParam()});
}

TEST_P(WriterFailure, MissingFolder) {
  TemporaryFolder folder;
  expect_error(ErrorCode::kIo, {"cannot write", "missing"},
               [&] { write_tet_mesh(folder / "missing" / GetParam(), sample_mesh()); });
}

INSTANTIATE_TEST_SUITE_P(Formats, WriterFailure, testing::Values("a.vtu", "a.msh", "a.mesh", "a.node"));

TEST(WriterFailureAtDevice, FullDeviceIsAnErrorAndStaysADevice) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const char* format : {"vtu", "msh22", "msh41", "medit"}) {
    SCOPED_TRACE(format);
    expect_error(ErrorCode::kIo, {"/dev/full", "No space left"}, [&] {
      write_tet_mesh("/dev/full", sample_mesh(), {.format = format, .ascii = false, .min_dihedral_deg = {}});
    });
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace unsliver::io
