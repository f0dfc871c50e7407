/// \file
/// An image as a PNG file (ISO/IEC 15948): 8-bit RGB, zlib.
#pragma once

#include <string>

#include "image.hpp"

namespace unsliver::cli {

/// The bytes of the file.
std::string encode_png(const Image& image);

}  // namespace unsliver::cli
