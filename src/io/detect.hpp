/// \file
/// What a file is: by its extension, and, for messages, by its first bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace unsliver::io {

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

/// The extension in lower case, with its dot: ".stl"; "" when there is none.
std::string extension_of(const std::filesystem::path& path);

/// What the first bytes look like, as a noun phrase ("a PLY file", "binary data"). Never fails.
std::string_view guess_content(std::string_view bytes);

/// Throws the Error for a file that is not what its extension says: kBadInput when it is empty, else kFormat.
/// `expected` tells what it should have been and how that begins: "an OFF file, which starts with 'OFF'".
[[noreturn]] void fail_wrong_content(std::string_view bytes, const std::string& name,
                                     std::string_view expected);

}  // namespace unsliver::io
