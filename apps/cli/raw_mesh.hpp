/// \file
/// A mesh as a folder of plain arrays, for meshes larger than memory: docs/STREAM.md.
#pragma once

#include <filesystem>
#include <optional>

#include "unsliver/mesh_sink.hpp"
#include "unsliver/verify_stream.hpp"

namespace unsliver::cli {

/// An open file that is read and written at places, from any thread. Errors are Error kIo.
class RawFile {
 public:
  enum class For { kReading, kWriting };
  RawFile(std::filesystem::path path, For purpose);
  ~RawFile();
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  std::uint64_t size() const;
  void read(std::uint64_t offset, std::span<std::byte> bytes) const;
  void write(std::uint64_t offset, std::span<const std::byte> bytes) const;

 private:
  [[noreturn]] void fail(const char* act, int error) const;

  std::filesystem::path path_;
  int file_ = -1;
};

struct RawFiles {
  RawFiles(const std::filesystem::path& folder, RawFile::For purpose);

  RawFile points, levels, tets;
};

/// Is it one of ours, by its looks: a folder?
bool is_raw_mesh(const std::filesystem::path& path);

/// \throws Error kIo where no folder can be made of that name, or there is something already.
void check_raw_output(const std::filesystem::path& folder);

/// Writes into a folder of another name beside the one asked for, which is renamed by commit(). Without that
/// nothing is left behind.
class RawMeshWriter : public MeshSink {
 public:
  explicit RawMeshWriter(std::filesystem::path folder);
  ~RawMeshWriter() override;

  /// \throws Error kIo where the disk has no room for it.
  void begin(const MeshHead& head) override;
  void points(std::uint64_t first, std::span<const Vec3> points,
              std::span<const std::uint8_t> levels) override;
  void tets(std::uint64_t first, std::span<const std::array<VertexId, 4>> tets) override;

  /// All arrays have come: writes the manifest. Then the folder, at its temporary place, can be read.
  void finish(const QualityLimits& limits);
  const std::filesystem::path& place() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path folder_, temporary_;
  MeshHead head_;
  std::optional<RawFiles> files_;
};

/// \throws Error kFormat or kIo naming the file: a manifest that is not one, files of other sizes than it
/// says.
class RawMeshReader : public MeshSource {
 public:
  explicit RawMeshReader(const std::filesystem::path& folder);

  MeshHead head() const override { return head_; }
  const std::optional<QualityLimits>& limits() const { return limits_; }
  void read_points(std::uint64_t first, std::span<Vec3> points, std::span<std::uint8_t> levels) override;
  void read_tets(std::uint64_t first, std::span<std::array<VertexId, 4>> tets) override;

 private:
  MeshHead head_;
  std::optional<QualityLimits> limits_;
  std::optional<RawFiles> files_;
};

/// The whole of it. \throws Error as above, and kLimit where memory does not hold it; kBadInput for indices
/// out of range and coordinates that are not finite.
TetMesh read_raw_mesh(const std::filesystem::path& folder);

}  // namespace unsliver::cli
