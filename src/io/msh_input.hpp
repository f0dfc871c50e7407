/// \file
/// The values of a Gmsh file, in text and binary alike.
#pragma once

#include <array>
#include <optional>

#include "io/scanner.hpp"

namespace unsliver::io {

/// Element kinds of Gmsh that we keep.
inline constexpr std::int64_t kMshTriangle = 2;
inline constexpr std::int64_t kMshTetrahedron = 4;

/// Nodes of an element of Gmsh's type; nothing for types not listed in the format's description.
std::optional<std::size_t> msh_node_count(std::int64_t type);

/// Reads the typed values of sections. In text the type only matters for the checks.
class MshInput {
 public:
  MshInput(std::string_view bytes, const std::string& name) : scanner_(bytes, name) {}

  Scanner& text() { return scanner_; }
  const Scanner& text() const { return scanner_; }
  bool binary() const { return scanner_.binary(); }

  /// An "int" of the format: 4 bytes.
  std::int64_t integer(std::string_view what) {
    return binary() ? scanner_.raw<std::int32_t>(what) : scanner_.integer(what);
  }
  /// A "size_t" of the format: 8 bytes.
  std::int64_t size(std::string_view what) {
    return binary() ? static_cast<std::int64_t>(scanner_.raw<std::uint64_t>(what)) : scanner_.integer(what);
  }
  /// A finite number.
  double real(std::string_view what) {
    return binary() ? scanner_.require_finite(scanner_.raw<double>(what), what) : scanner_.number(what);
  }
  Vec3 point() {
    const double x = real("coordinate x");
    const double y = real("coordinate y");
    const double z = real("coordinate z");
    return {x, y, z};
  }
  void skip_reals(std::int64_t count);
  void skip_integers(std::int64_t count);
  /// Checks a declared number of rows against the bytes left: each takes at least `values` values of at least
  /// `binary_size` bytes together.
  std::size_t require_rows(std::int64_t rows, std::size_t values, std::size_t binary_size,
                           std::string_view what) const {
    return scanner_.require_room(rows, binary() ? binary_size : 2 * values, what);
  }

 private:
  Scanner scanner_;
};

}  // namespace unsliver::io
