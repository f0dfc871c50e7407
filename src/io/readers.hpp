/// \file
/// Readers of formats, from bytes in memory. `name` is the file's name for messages. All are safe on any
/// bytes: they throw an Error or return a mesh whose indices are valid and whose coordinates are finite, and
/// take memory in proportion to the bytes given. Contracts and errors: unsliver/io.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/points.hpp"

namespace unsliver::io {

/// What a file must hold to be of use. kPoints: a mesh may come back without elements, even without points.
enum class Need { kElements, kPoints };

TriangleMesh parse_stl(std::string_view bytes, const std::string& name, Need need = Need::kElements);
TriangleMesh parse_obj(std::string_view bytes, const std::string& name, Need need = Need::kElements);
TriangleMesh parse_off(std::string_view bytes, const std::string& name, Need need = Need::kElements);
TriangleMesh parse_ply(std::string_view bytes, const std::string& name, Need need = Need::kElements);

TetMesh parse_vtu(std::string_view bytes, const std::string& name, Need need = Need::kElements);
TetMesh parse_msh(std::string_view bytes, const std::string& name, Need need = Need::kElements);
TetMesh parse_medit(std::string_view bytes, const std::string& name, Need need = Need::kElements);

/// Points and nothing else; at least one. Sizes are positive.
PointSet parse_xyz(std::string_view bytes, const std::string& name);
PointSet parse_csv(std::string_view bytes, const std::string& name);
PointSet parse_pqr(std::string_view bytes, const std::string& name);
PointSet parse_node(std::string_view bytes, const std::string& name);

/// The files of one TetGen mesh. An empty `face` stands for a file that does not exist.
struct TetgenBytes {
  std::string_view node, ele, face;
};
/// `stem` is the path without extension, for messages.
TetMesh parse_tetgen(const TetgenBytes& bytes, const std::string& stem);

/// Scalar values at vertices: MEDIT .sol, TetGen .mtr. Error kBadInput when there are not `vertex_count`.
std::vector<double> parse_sol(std::string_view bytes, const std::string& name, std::size_t vertex_count);
std::vector<double> parse_mtr(std::string_view bytes, const std::string& name, std::size_t vertex_count);

}  // namespace unsliver::io
