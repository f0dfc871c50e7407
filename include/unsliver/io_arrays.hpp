/// \file
/// Arrays with names in files. Errors and half-written files: as in io.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>

#include "unsliver/mesh.hpp"

namespace unsliver::io {

/// Rows of `columns` numbers each, one after another.
struct NamedArray {
  std::string name;
  std::size_t columns = 1;
  std::variant<std::span<const double>, std::span<const std::int64_t>> values;
};

/// numpy's .npz: numpy.load gives each array by its name, of shape (rows,) where columns = 1, else (rows,
/// columns). Not compressed. \throws Error kUnsupported from 4 GiB on.
void write_npz(const std::filesystem::path& path, std::span<const NamedArray> arrays);

/// VTU with a triangle a cell. Requires arrays with one row a point.
void write_surface_vtu(const std::filesystem::path& path, const TriangleMesh& surface,
                       std::span<const NamedArray> point_arrays);

}  // namespace unsliver::io
