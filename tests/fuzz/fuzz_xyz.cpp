#include "fuzz_reader.hpp"
#include "io/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  unsliver::fuzz::check_reader({reinterpret_cast<const char*>(data), size},
                               [](std::string_view bytes) { return unsliver::io::parse_xyz(bytes, "fuzz"); });
  return 0;
}
