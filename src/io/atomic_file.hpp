/// \file
/// A file that appears whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace unsliver::io {

/// Writes go to a temporary name in the destination's folder; commit() renames it. Without commit() the
/// temporary file is removed and the destination stays as it was. A symbolic link is followed; a destination
/// that is a device or pipe is written directly. All errors of the system, at the end too, are Error kIo.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& destination);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// Nothing may be written afterwards.
  void commit();

 private:
  void open_directly();
  void open_temporary();
  void close();
  [[noreturn]] void fail_to(const char* act, int error) const;

  std::filesystem::path asked_;        // as the caller named it, for messages
  std::filesystem::path destination_;  // with links followed
  std::filesystem::path temporary_;    // "" when writing directly
  std::FILE* file_ = nullptr;
};

}  // namespace unsliver::io
