/// \file
/// VTU: pieces are joined; tetrahedra (VTK type 10) and triangles (5) are kept.
#include <cmath>
#include <span>

#include "io/fail.hpp"
#include "io/readers.hpp"
#include "io/tet_mesh_checks.hpp"
#include "io/vtu_document.hpp"
#include "io/vtu_names.hpp"
#include "io/vtu_values.hpp"

namespace unsliver::io {
namespace {

class VtuReader {
 public:
  VtuReader(std::string_view bytes, const std::string& name) : document_(parse_vtu_document(bytes, name)) {}

  TetMesh read() {
    for (const VtuPiece& piece : document_.pieces) read_piece(piece);
    drop_incomplete_arrays();
    read_frame();
    read_limits();
    read_periodicity();
    return std::move(mesh_);
  }

 private:
  // One piece's cells, not yet split by type.
  struct Cells {
    std::vector<std::int64_t> connectivity, ends, types;
    std::vector<std::int64_t> labels;  // empty when the piece has none
  };

  void read_piece(const VtuPiece& piece) {
    const std::size_t first_point = mesh_.points.size();
    append_points(piece);
    const std::size_t point_count = mesh_.points.size() - first_point;
    append_narrowed(piece, kVtuLevel, point_count, mesh_.levels);
    append_narrowed(piece, kVtuPointSource, point_count, mesh_.point_source);
    append_cells(read_cells(piece), first_point, point_count);
  }

  void append_points(const VtuPiece& piece) {
    const std::vector<double> values = vtu_values<double>(document_, require(piece, "Points", ""));
    if (values.size() % 3 != 0 || values.size() / 3 != piece.point_count)
      fail(ErrorCode::kFormat, "{}: {} points are declared, but {} coordinates are given", document_.name,
           piece.point_count, values.size());
    if (mesh_.points.size() + piece.point_count >= kNoVertex)
      fail(ErrorCode::kLimit, "{}: more points than a mesh can number", document_.name);
    for (std::size_t i = 0; i < values.size(); i += 3) {
      const Vec3& p = mesh_.points.emplace_back(Vec3{values[i], values[i + 1], values[i + 2]});
      if (!is_finite(p))
        fail(ErrorCode::kBadInput, "{}: point {} is ({}, {}, {}); coordinates must be finite", document_.name,
             i / 3, p.x, p.y, p.z);
    }
  }

  Cells read_cells(const VtuPiece& piece) const {
    Cells cells;
    cells.connectivity = vtu_values<std::int64_t>(document_, require(piece, "Cells", "connectivity"));
    cells.ends = vtu_values<std::int64_t>(document_, require(piece, "Cells", "offsets"));
    cells.types = vtu_values<std::int64_t>(document_, require(piece, "Cells", "types"));
    if (cells.ends.size() != piece.cell_count || cells.types.size() != piece.cell_count)
      fail(ErrorCode::kFormat, "{}: {} cells are declared, but {} offsets and {} types are given",
           document_.name, piece.cell_count, cells.ends.size(), cells.types.size());
    for (const std::string_view name : kVtuRegionNames) {
      const VtuArray* labels = piece.find("CellData", name);
      if (!labels) continue;
      cells.labels = vtu_values<std::int64_t>(document_, *labels);
      if (cells.labels.size() == piece.cell_count) break;
      cells.labels.clear();
    }
    return cells;
  }

  void append_cells(const Cells& cells, std::size_t first_point, std::size_t point_count) {
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < cells.ends.size(); ++i) {
      const std::int64_t end = cells.ends[i];
      if (end < begin || end > static_cast<std::int64_t>(cells.connectivity.size()))
        fail(ErrorCode::kFormat, "{}: the offset of cell {} is {}; valid are {} to {}", document_.name, i,
             end, begin, cells.connectivity.size());
      const std::span corners(cells.connectivity.data() + begin, static_cast<std::size_t>(end - begin));
      begin = end;
      if (cells.types[i] == kVtkTetra)
        append_cell(i, corners, cells, first_point, point_count, mesh_.tets, mesh_.regions);
      if (cells.types[i] == kVtkTriangle)
        append_cell(i, corners, cells, first_point, point_count, mesh_.triangles, mesh_.triangle_labels);
    }
  }

  template <std::size_t N>
  void append_cell(std::size_t cell, std::span<const std::int64_t> corners, const Cells& cells,
                   std::size_t first_point, std::size_t point_count,
                   std::vector<std::array<VertexId, N>>& elements, std::vector<std::int32_t>& labels) const {
    if (corners.size() != N)
      fail(ErrorCode::kFormat, "{}: cell {} has {} points, but its type needs {}", document_.name, cell,
           corners.size(), N);
    auto& element = elements.emplace_back();
    for (std::size_t i = 0; i < N; ++i) {
      if (corners[i] < 0 || corners[i] >= static_cast<std::int64_t>(point_count))
        fail(ErrorCode::kBadInput, "{}: cell {} uses point {}; valid are 0 to {}", document_.name, cell,
             corners[i], static_cast<std::int64_t>(point_count) - 1);
      element[i] = static_cast<VertexId>(first_point + static_cast<std::size_t>(corners[i]));
    }
    if (!cells.labels.empty()) labels.push_back(narrowed<std::int32_t>(cells.labels[cell], kVtuRegion));
  }

  template <class T>
  void append_narrowed(const VtuPiece& piece, std::string_view name, std::size_t count, std::vector<T>& out) {
    const VtuArray* array = piece.find("PointData", name);
    if (!array) return;
    const std::vector<std::int64_t> values = vtu_values<std::int64_t>(document_, *array);
    if (values.size() != count)
      fail(ErrorCode::kFormat, "{}: array '{}' has {} values for {} points", document_.name, name,
           values.size(), count);
    for (const std::int64_t value : values) out.push_back(narrowed<T>(value, name));
  }

  template <class T>
  T narrowed(std::int64_t value, std::string_view name) const {
    if (value != static_cast<std::int64_t>(static_cast<T>(value)))
      fail(ErrorCode::kBadInput, "{}: a value of array '{}' is {}, which is out of range", document_.name,
           name, value);
    return static_cast<T>(value);
  }

  // An array that only some pieces have is of no use.
  void drop_incomplete_arrays() {
    if (mesh_.levels.size() != mesh_.points.size()) mesh_.levels.clear();
    if (mesh_.point_source.size() != mesh_.points.size()) mesh_.point_source.clear();
    if (mesh_.regions.size() != mesh_.tets.size()) mesh_.regions.clear();
    if (mesh_.triangle_labels.size() != mesh_.triangles.size()) mesh_.triangle_labels.clear();
  }

  void read_frame() {
    const VtuArray* array = document_.field_data.find("FieldData", kVtuFrame);
    if (!array) return;
    const std::vector<double> v = vtu_values<double>(document_, *array);
    if (v.size() != 4 || !std::isfinite(v[0]) || v[0] <= 0 || !is_finite({v[1], v[2], v[3]}))
      fail(ErrorCode::kBadInput, "{}: array '{}' must hold a positive unit and an origin", document_.name,
           kVtuFrame);
    mesh_.frame = Frame{v[0], {v[1], v[2], v[3]}};
  }

  void read_limits() {
    const VtuArray* array = document_.field_data.find("FieldData", kVtuLimits);
    if (!array) return;
    const std::vector<double> v = vtu_values<double>(document_, *array);
    if (v.size() != 3 || !(0 <= v[0] && v[0] <= v[1] && v[1] <= 180 && v[2] > 0))
      fail(
          ErrorCode::kBadInput,
          "{}: array '{}' must hold a smallest and a largest dihedral angle, in degrees from 0 to 180, and a "
          "positive radius-edge ratio; without the array the mesh is judged as any other",
          document_.name, kVtuLimits);
    mesh_.limits = QualityLimits{v[0], v[1], v[2]};
  }

  /// Points are numbered by piece, so there must be one.
  void read_periodicity() {
    const VtuArray* cell = document_.field_data.find("FieldData", kVtuCell);
    if (!cell || document_.pieces.size() != 1) return;
    const VtuPiece& piece = document_.pieces.front();
    const auto of_points = [&](std::string_view name) {
      return vtu_values<std::int64_t>(document_, require(piece, "PointData", name));
    };
    const std::vector<double> v = vtu_values<double>(document_, *cell);
    const std::vector<std::int64_t> homes = of_points(kVtuHome), shifts = of_points(kVtuShift);
    if (v.size() != 6 || homes.size() != mesh_.points.size() || shifts.size() != 3 * homes.size())
      fail(ErrorCode::kFormat,
           "{}: a periodic mesh needs six numbers in '{}', and for each point one in '{}' and "
           "three in '{}'",
           document_.name, kVtuCell, kVtuHome, kVtuShift);
    Periodicity& periodicity = mesh_.periodicity.emplace();
    periodicity.cell = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
    for (const std::int64_t home : homes) periodicity.home.push_back(narrowed<VertexId>(home, kVtuHome));
    for (std::size_t i = 0; i < shifts.size(); i += 3) {
      auto& shift = periodicity.shift.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis)
        shift[axis] = narrowed<std::int8_t>(shifts[i + axis], kVtuShift);
    }
  }

  const VtuArray& require(const VtuPiece& piece, std::string_view section, std::string_view name) const {
    const VtuArray* array = piece.find(section, name);
    if (!array)
      fail(ErrorCode::kFormat, "{}: a piece has no array '{}' in {}", document_.name, name, section);
    return *array;
  }

  VtuDocument document_;
  TetMesh mesh_;
};

}  // namespace

TetMesh parse_vtu(std::string_view bytes, const std::string& name, Need need) {
  TetMesh mesh = VtuReader(bytes, name).read();
  if (need == Need::kElements) require_tets(mesh, name);
  return mesh;
}

}  // namespace unsliver::io
