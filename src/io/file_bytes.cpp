#include "io/file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "io/fail.hpp"

namespace unsliver::io {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using InputFile = std::unique_ptr<std::FILE, CloseFile>;

constexpr std::size_t kChunk = std::size_t{1} << 20;

// The size that the file system states; 0 for pipes and devices, which state none.
std::size_t size_hint(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return 0;
  const auto size = std::filesystem::file_size(path, ignored);
  return ignored ? 0 : static_cast<std::size_t>(size);
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, int error) {
  fail(ErrorCode::kIo, "cannot read '{}': {}", path.string(), std::strerror(error));
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  const InputFile file(std::fopen(path.string().c_str(), "rb"));
  if (!file) fail_to_read(path, errno);

  std::string bytes;
  std::size_t filled = 0;
  bytes.resize(size_hint(path) + 1);  // one more, so that the end is met without growing
  while (true) {
    filled += std::fread(bytes.data() + filled, 1, bytes.size() - filled, file.get());
    if (std::ferror(file.get())) fail_to_read(path, errno);
    if (filled < bytes.size()) break;
    bytes.resize(bytes.size() + std::max(kChunk, bytes.size() / 2));
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace unsliver::io
