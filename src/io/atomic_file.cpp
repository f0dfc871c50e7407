#include "io/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

namespace fs = std::filesystem;

constexpr int kMostAttempts = 1000;

fs::path with_links_followed(const fs::path& path) {
  std::error_code ignored;
  fs::path resolved = fs::weakly_canonical(path, ignored);
  return ignored ? path : resolved;
}

bool is_device_or_pipe(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& destination)
    : asked_(destination), destination_(with_links_followed(destination)) {
  std::error_code ignored;
  if (fs::is_directory(destination_, ignored)) fail_to("write", EISDIR);
  if (is_device_or_pipe(destination_))
    open_directly();
  else
    open_temporary();
}

void AtomicFile::open_directly() {
  file_ = std::fopen(destination_.string().c_str(), "wb");
  if (!file_) fail_to("write", errno);
}

// The exclusive mode makes the choice of a free name safe against other processes.
void AtomicFile::open_temporary() {
  for (int attempt = 0; attempt < kMostAttempts && !file_; ++attempt) {
    temporary_ = destination_;
    temporary_ += fmt::format(".part{}", attempt);
    file_ = std::fopen(temporary_.string().c_str(), "wbx");
    if (!file_ && errno != EEXIST) break;
  }
  if (file_) return;
  const int error = errno;
  temporary_.clear();
  fail_to("write", error);
}

AtomicFile::~AtomicFile() {
  if (file_) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view bytes) {
  if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    fail_to("write", errno);
}

void AtomicFile::close() {
  const int status = std::fclose(std::exchange(file_, nullptr));
  if (status != 0) fail_to("finish writing", errno);
}

void AtomicFile::commit() {
  close();
  if (temporary_.empty()) return;
  std::error_code error;
  const fs::file_status old = fs::status(destination_, error);
  if (fs::exists(old)) fs::permissions(temporary_, old.permissions(), error);
  fs::rename(temporary_, destination_, error);
  if (error) fail_to("rename the finished file to", error.value());
  temporary_.clear();
}

void AtomicFile::fail_to(const char* act, int error) const {
  fail(ErrorCode::kIo, "cannot {} '{}': {}", act, asked_.string(), std::strerror(error));
}

}  // namespace unsliver::io
