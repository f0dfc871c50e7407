#include "raw_mesh.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "files.hpp"
#include "raw_manifest.hpp"
#include "resources.hpp"
#include "text.hpp"
#include "unsliver/error.hpp"

namespace unsliver::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestName = "manifest.json";
constexpr std::uint64_t kLongestManifest = 1 << 20;

[[noreturn]] void fail(const fs::path& path, const std::string& what, ErrorCode code = ErrorCode::kIo) {
  throw Error(code, fmt::format("{}: {}", path.string(), what));
}

std::uint64_t total_bytes(const MeshHead& head) {
  return head.vertices * (kRawPoints.bytes + kRawLevels.bytes) + head.tets * kRawTets.bytes;
}

fs::path without_slash(fs::path folder) { return folder.has_filename() ? folder : folder.parent_path(); }

std::string read_manifest(const fs::path& path) {
  if (std::error_code ignored; !fs::is_regular_file(path, ignored))
    fail(path, "there is no such file: the folder is no mesh of `unsliver mesh --stream`");
  const RawFile file(path, RawFile::For::kReading);
  if (file.size() > kLongestManifest) fail(path, "too long for a manifest", ErrorCode::kFormat);
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  file.read(0, std::as_writable_bytes(std::span(text)));
  return text;
}

void check_size(const fs::path& folder, const RawArray& array, const RawFile& file, std::uint64_t items) {
  if (file.size() == items * array.bytes) return;
  fail(folder / array.name,
       fmt::format("{} bytes, where the manifest says {}: the file is cut off or of another mesh",
                   file.size(), items * array.bytes),
       ErrorCode::kFormat);
}

void check_arrays(const fs::path& folder, const TetMesh& mesh) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!is_finite(mesh.points[v]))
      fail(folder / kRawPoints.name, fmt::format("vertex {} is not finite", v), ErrorCode::kBadInput);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (*std::max_element(mesh.tets[t].begin(), mesh.tets[t].end()) >= mesh.points.size())
      fail(folder / kRawTets.name,
           fmt::format("tetrahedron {} has a vertex beyond the last, {}", t, mesh.points.size()),
           ErrorCode::kBadInput);
}

}  // namespace

RawFile::RawFile(fs::path path, For purpose) : path_(std::move(path)) {
  const bool writing = purpose == For::kWriting;
  file_ =
      ::open(path_.c_str(), writing ? O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC : O_RDONLY | O_CLOEXEC, 0666);
  if (file_ < 0) fail(writing ? "create" : "open", errno);
}

RawFile::~RawFile() { ::close(file_); }

std::uint64_t RawFile::size() const {
  struct stat status {};
  if (::fstat(file_, &status) != 0) fail("look at", errno);
  return static_cast<std::uint64_t>(status.st_size);
}

void RawFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("read", errno);
    if (count == 0) fail("read to its end", EIO);
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void RawFile::write(std::uint64_t offset, std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail("write", count < 0 ? errno : ENOSPC);
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void RawFile::fail(const char* act, int error) const {
  throw Error(ErrorCode::kIo, fmt::format("cannot {} '{}': {}", act, path_.string(), std::strerror(error)));
}

RawFiles::RawFiles(const fs::path& folder, RawFile::For purpose)
    : points(folder / kRawPoints.name, purpose),
      levels(folder / kRawLevels.name, purpose),
      tets(folder / kRawTets.name, purpose) {}

bool is_raw_mesh(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

void check_raw_output(const fs::path& folder) {
  const fs::path path = without_slash(folder);
  if (std::error_code ignored; fs::exists(fs::symlink_status(path, ignored)))
    fail(path, "--stream makes a new folder, and there is something of that name: remove it or name another");
  check_writable(path, "--stream");
}

RawMeshWriter::RawMeshWriter(fs::path folder) : folder_(without_slash(std::move(folder))) {
  temporary_ = folder_;
  temporary_ += fmt::format(".{}.part", getpid());
  std::error_code error;
  if (!fs::create_directory(temporary_, error))
    fail(temporary_, "cannot be made: " + (error ? error.message() : "it is there already"));
}

RawMeshWriter::~RawMeshWriter() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void RawMeshWriter::begin(const MeshHead& head) {
  head_ = head;
  std::error_code unknown;
  const fs::space_info space = fs::space(temporary_, unknown);
  if (!unknown && space.available < total_bytes(head))
    fail(folder_, fmt::format("the mesh takes {}, and the disk has {} left",
                              human_bytes(static_cast<double>(total_bytes(head))),
                              human_bytes(static_cast<double>(space.available))));
  files_.emplace(temporary_, RawFile::For::kWriting);
}

void RawMeshWriter::points(std::uint64_t first, std::span<const Vec3> points,
                           std::span<const std::uint8_t> levels) {
  files_->points.write(first * kRawPoints.bytes, std::as_bytes(points));
  files_->levels.write(first * kRawLevels.bytes, std::as_bytes(levels));
}

void RawMeshWriter::tets(std::uint64_t first, std::span<const std::array<VertexId, 4>> tets) {
  files_->tets.write(first * kRawTets.bytes, std::as_bytes(tets));
}

void RawMeshWriter::finish(const QualityLimits& limits) {
  files_.reset();
  const std::string text = to_text({head_, limits});
  const RawFile manifest(temporary_ / kManifestName, RawFile::For::kWriting);
  manifest.write(0, std::as_bytes(std::span(text)));
}

void RawMeshWriter::commit() {
  std::error_code error;
  fs::rename(temporary_, folder_, error);
  if (error) fail(folder_, "cannot be renamed to from " + temporary_.string() + ": " + error.message());
  temporary_.clear();
}

RawMeshReader::RawMeshReader(const fs::path& folder) {
  const fs::path path = folder / kManifestName;
  const RawManifest manifest = parse_manifest(read_manifest(path), path.string());
  head_ = manifest.head;
  limits_ = manifest.limits;
  files_.emplace(folder, RawFile::For::kReading);
  check_size(folder, kRawPoints, files_->points, head_.vertices);
  check_size(folder, kRawLevels, files_->levels, head_.vertices);
  check_size(folder, kRawTets, files_->tets, head_.tets);
}

void RawMeshReader::read_points(std::uint64_t first, std::span<Vec3> points, std::span<std::uint8_t> levels) {
  files_->points.read(first * kRawPoints.bytes, std::as_writable_bytes(points));
  files_->levels.read(first * kRawLevels.bytes, std::as_writable_bytes(levels));
}

void RawMeshReader::read_tets(std::uint64_t first, std::span<std::array<VertexId, 4>> tets) {
  files_->tets.read(first * kRawTets.bytes, std::as_writable_bytes(tets));
}

TetMesh read_raw_mesh(const fs::path& folder) {
  RawMeshReader reader(folder);
  const MeshHead head = reader.head();
  if (const std::uint64_t memory = available_memory(); memory != 0 && total_bytes(head) > memory)
    fail(folder,
         fmt::format("the mesh takes {}, more than the {} of memory available",
                     human_bytes(static_cast<double>(total_bytes(head))),
                     human_bytes(static_cast<double>(memory))),
         ErrorCode::kLimit);
  TetMesh mesh;
  mesh.frame = head.frame;
  mesh.limits = reader.limits();
  mesh.points.resize(static_cast<std::size_t>(head.vertices));
  mesh.levels.resize(mesh.points.size());
  mesh.tets.resize(static_cast<std::size_t>(head.tets));
  reader.read_points(0, mesh.points, mesh.levels);
  reader.read_tets(0, mesh.tets);
  check_arrays(folder, mesh);
  return mesh;
}

}  // namespace unsliver::cli
