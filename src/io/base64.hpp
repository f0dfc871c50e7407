/// \file
/// Base64 as VTK files hold it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace unsliver::io {

/// The bytes that `text` encodes. White space is skipped. Padding may stand within the text: what was encoded
/// in parts (a header, then the data) decodes to the parts joined. Nothing when it is not base64.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace unsliver::io
