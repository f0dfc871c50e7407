#include <algorithm>

#include "fuzz_reader.hpp"
#include "io/readers.hpp"

namespace {

/// The input holds the files .node, .ele and .face, each but the last ended by a zero byte.
unsliver::TetMesh parse_joined(std::string_view bytes) {
  const auto next = [&] {
    const std::string_view part = bytes.substr(0, bytes.find('\0'));
    bytes.remove_prefix(std::min(part.size() + 1, bytes.size()));
    return part;
  };
  const std::string_view node = next(), ele = next(), face = next();
  return unsliver::io::parse_tetgen({node, ele, face}, "fuzz");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  unsliver::fuzz::check_reader({reinterpret_cast<const char*>(data), size}, parse_joined);
  return 0;
}
