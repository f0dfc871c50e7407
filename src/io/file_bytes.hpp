/// \file
/// A whole file as a string of bytes.
#pragma once

#include <filesystem>
#include <string>

namespace unsliver::io {

/// The content of the file (or pipe) at `path`. Error kIo when it cannot be opened or read to its end.
std::string read_file(const std::filesystem::path& path);

}  // namespace unsliver::io
