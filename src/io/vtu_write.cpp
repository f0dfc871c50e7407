/// \file
/// VTU: raw appended arrays in zlib blocks. The arrays are compressed first, since the tags in front of them
/// state where each one starts.
#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/vtu_names.hpp"
#include "io/writers.hpp"
#include "io/zlib_blocks.hpp"

namespace unsliver::io {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are written as they lie in memory");

template <class T>
constexpr std::string_view vtk_type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
}

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

class VtuWriter {
 public:
  VtuWriter(const TetMesh& mesh, std::span<const float> min_dihedral_deg,
            std::span<const NamedArray> point_arrays)
      : mesh_(mesh), min_dihedral_deg_(min_dihedral_deg), point_arrays_(point_arrays) {}

  void write(const std::filesystem::path& path) {
    AtomicFile file(path);  // first: a path that cannot be written costs no compression
    describe();
    file.write(tags_);
    for (const std::string& array : appended_) file.write(array);
    file.write("\n  </AppendedData>\n</VTKFile>\n");
    file.commit();
  }

 private:
  std::size_t cell_count() const { return mesh_.tets.size() + mesh_.triangles.size(); }

  // Fills tags_ and appended_.
  void describe() {
    constexpr bool kBig = std::endian::native == std::endian::big;
    tag("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"",
        kBig ? "BigEndian" : "LittleEndian",
        "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <UnstructuredGrid>\n");
    if (mesh_.frame || mesh_.limits || mesh_.periodicity)
      section("FieldData", [&] { describe_field_data(); });
    tag("    <Piece NumberOfPoints=\"", std::to_string(mesh_.points.size()), "\" NumberOfCells=\"",
        std::to_string(cell_count()), "\">\n");
    section("PointData", [&] { describe_point_data(); });
    section("CellData", [&] { describe_cell_data(); });
    section("Points", [&] { describe_points(); });
    section("Cells", [&] { describe_cells(); });
    tag("    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n   _");
  }

  void describe_field_data() {
    if (const auto& f = mesh_.frame) {
      const double values[] = {f->unit, f->origin.x, f->origin.y, f->origin.z};
      array<double>(kVtuFrame, values, "NumberOfTuples=\"4\" ");
    }
    if (const auto& l = mesh_.limits) {
      const double values[] = {l->min_dihedral_deg, l->max_dihedral_deg, l->max_radius_edge};
      array<double>(kVtuLimits, values, "NumberOfTuples=\"3\" ");
    }
    if (const auto& p = mesh_.periodicity) {
      const double values[] = {p->cell.lo.x, p->cell.lo.y, p->cell.lo.z,
                               p->cell.hi.x, p->cell.hi.y, p->cell.hi.z};
      array<double>(kVtuCell, values, "NumberOfTuples=\"6\" ");
    }
  }

  void describe_point_data() {
    if (!mesh_.levels.empty()) array<std::uint8_t>(kVtuLevel, mesh_.levels);
    if (!mesh_.point_source.empty()) array<std::int64_t>(kVtuPointSource, mesh_.point_source);
    if (mesh_.periodicity) describe_periodicity(*mesh_.periodicity);
    for (const NamedArray& named : point_arrays_) describe(named);
  }

  void describe_periodicity(const Periodicity& periodicity) {
    const std::vector<std::int64_t> homes(periodicity.home.begin(), periodicity.home.end());
    array<std::int64_t>(kVtuHome, homes);
    std::vector<std::int32_t> shifts;
    shifts.reserve(3 * periodicity.shift.size());
    for (const auto& shift : periodicity.shift) shifts.insert(shifts.end(), shift.begin(), shift.end());
    array<std::int32_t>(kVtuShift, shifts, "NumberOfComponents=\"3\" ");
  }

  void describe(const NamedArray& named) {
    std::string shape;
    if (named.columns > 1) shape = "NumberOfComponents=\"" + std::to_string(named.columns) + "\" ";
    std::visit([&]<class T>(const std::span<const T>& values) { array<T>(named.name, values, shape); },
               named.values);
  }

  void describe_cell_data() {
    if (!mesh_.regions.empty() || !mesh_.triangle_labels.empty())
      cell_array<std::int32_t>(kVtuRegion, mesh_.regions, mesh_.triangle_labels, 0);
    if (!min_dihedral_deg_.empty())
      cell_array<float>(kVtuMinDihedral, min_dihedral_deg_, {}, std::numeric_limits<float>::quiet_NaN());
  }

  void describe_points() {
    const std::span coordinates(reinterpret_cast<const double*>(mesh_.points.data()),
                                3 * mesh_.points.size());
    array<double>("Points", coordinates, "NumberOfComponents=\"3\" ");
  }

  void describe_cells() {
    constexpr std::uint64_t kMaxInt32 = std::numeric_limits<std::int32_t>::max();
    const std::uint64_t entries = 4 * mesh_.tets.size() + 3 * mesh_.triangles.size();
    if (mesh_.points.size() > kMaxInt32)
      array<std::int64_t>("connectivity", connectivity<std::int64_t>(entries));
    else if (mesh_.triangles.empty() && !mesh_.tets.empty())
      index_array("connectivity", {mesh_.tets.front().data(), entries});
    else
      index_array("connectivity", connectivity<std::uint32_t>(entries));
    if (entries > kMaxInt32)
      array<std::int64_t>("offsets", ends<std::int64_t>());
    else
      index_array("offsets", ends<std::uint32_t>());
    std::vector<std::uint8_t> types(cell_count(), kVtkTriangle);
    std::fill_n(types.begin(), mesh_.tets.size(), static_cast<std::uint8_t>(kVtkTetra));
    array<std::uint8_t>("types", types);
  }

  template <class Integer>
  std::vector<Integer> connectivity(std::uint64_t entries) const {
    std::vector<Integer> all;
    all.reserve(entries);
    for (const auto& tet : mesh_.tets) all.insert(all.end(), tet.begin(), tet.end());
    for (const auto& triangle : mesh_.triangles) all.insert(all.end(), triangle.begin(), triangle.end());
    return all;
  }

  template <class Integer>
  std::vector<Integer> ends() const {
    std::vector<Integer> all;
    all.reserve(cell_count());
    Integer end = 0;
    for (std::size_t i = 0; i < mesh_.tets.size(); ++i) all.push_back(end += 4);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) all.push_back(end += 3);
    return all;
  }

  template <class Content>
  void section(std::string_view name, const Content& content) {
    tag("      <", name, ">\n");
    content();
    tag("      </", name, ">\n");
  }

  template <class T>
  void array(std::string_view name, std::span<const T> values, std::string_view shape = "") {
    append<T>(name, shape, compress_blocks(bytes_of(values)));
  }

  // Requires indices below 2^31.
  void index_array(std::string_view name, std::span<const std::uint32_t> indices) {
    append<std::int32_t>(name, "", compress_blocks(bytes_of(indices)));
  }

  // Values of the tetrahedra, then of the triangles; `missing` for those that have none.
  template <class T>
  void cell_array(std::string_view name, std::span<const T> of_tets, std::span<const T> of_triangles,
                  T missing) {
    if (of_tets.size() == cell_count()) return array<T>(name, of_tets);
    std::vector<T> all(of_tets.begin(), of_tets.end());
    all.resize(mesh_.tets.size(), missing);
    all.insert(all.end(), of_triangles.begin(), of_triangles.end());
    all.resize(cell_count(), missing);
    array<T>(name, all);
  }

  template <class T>
  void append(std::string_view name, std::string_view shape, std::string compressed) {
    tag("        <DataArray type=\"", vtk_type_name<T>(), "\" Name=\"", name, "\" ", shape,
        "format=\"appended\" offset=\"", std::to_string(appended_size_), "\"/>\n");
    appended_size_ += compressed.size();
    appended_.push_back(std::move(compressed));
  }

  template <class... Parts>
  void tag(const Parts&... parts) {
    (tags_.append(parts), ...);
  }

  const TetMesh& mesh_;
  std::span<const float> min_dihedral_deg_;
  std::span<const NamedArray> point_arrays_;
  std::string tags_;
  std::vector<std::string> appended_;
  std::uint64_t appended_size_ = 0;
};

}  // namespace

void write_vtu(const std::filesystem::path& path, const TetMesh& mesh,
               std::span<const float> min_dihedral_deg, std::span<const NamedArray> point_arrays) {
  VtuWriter(mesh, min_dihedral_deg, point_arrays).write(path);
}

void write_surface_vtu(const std::filesystem::path& path, const TriangleMesh& surface,
                       std::span<const NamedArray> point_arrays) {
  TetMesh triangles;
  triangles.points = surface.points;
  triangles.triangles = surface.triangles;
  write_vtu(path, triangles, {}, point_arrays);
}

}  // namespace unsliver::io
