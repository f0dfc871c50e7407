#include "io/msh_input.hpp"

namespace unsliver::io {

std::optional<std::size_t> msh_node_count(std::int64_t type) {
  // By type, from 1: line, triangle, quadrangle, tetrahedron, hexahedron, prism, pyramid, then higher orders.
  constexpr std::array<std::uint8_t, 31> kCounts{2,  3,  4,  4, 8,  6,  5,  3,  6,  9, 10, 27, 18, 14, 1, 8,
                                                 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5,  6,  20, 35, 56};
  if (type == 92) return 64;
  if (type == 93) return 125;
  if (type < 1 || type > static_cast<std::int64_t>(kCounts.size())) return std::nullopt;
  return kCounts[static_cast<std::size_t>(type - 1)];
}

void MshInput::skip_reals(std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) {
    if (binary())
      scanner_.take(sizeof(double), "a number");
    else
      scanner_.word("a number");
  }
}

void MshInput::skip_integers(std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) integer("an integer");
}

}  // namespace unsliver::io
