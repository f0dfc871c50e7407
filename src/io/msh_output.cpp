#include "io/msh_output.hpp"

namespace unsliver::io {

MshOutput::MshOutput(const std::filesystem::path& path, std::string_view version, bool ascii)
    : out_(path), ascii_(ascii) {
  begin("MeshFormat");
  out_.print(version, ascii ? " 0 8\n" : " 1 8\n");
  if (!ascii) out_.put_raw(std::int32_t{1});  // tells the reader the byte order
  end("MeshFormat");
}

}  // namespace unsliver::io
