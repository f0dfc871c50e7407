/// \file
/// The public face: which extension goes to which reader and writer.
#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/file_bytes.hpp"
#include "io/point_checks.hpp"
#include "io/readers.hpp"
#include "io/tet_mesh_checks.hpp"
#include "io/writers.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

namespace fs = std::filesystem;

struct SurfaceFormat {
  const char* name;
  const char* extension;
  TriangleMesh (*parse)(std::string_view, const std::string&, Need);
};
constexpr std::array kSurfaceFormats{
    SurfaceFormat{"stl", ".stl", &parse_stl},
    SurfaceFormat{"obj", ".obj", &parse_obj},
    SurfaceFormat{"off", ".off", &parse_off},
    SurfaceFormat{"ply", ".ply", &parse_ply},
};

// Of need for points alone, the file of the nodes is enough.
TetMesh read_tetgen(const fs::path& path, Need need) {
  const auto sibling = [&](const char* extension) { return fs::path(path).replace_extension(extension); };
  const std::string node = read_file(sibling(".node"));
  if (need == Need::kPoints) {
    TetMesh mesh;
    mesh.points = parse_node(node, sibling(".node").string()).points;
    return mesh;
  }
  const std::string ele = read_file(sibling(".ele"));
  std::error_code ignored;
  const std::string face = fs::exists(sibling(".face"), ignored) ? read_file(sibling(".face")) : "";
  return parse_tetgen({node, ele, face}, sibling("").string());
}

template <TetMesh (*parse)(std::string_view, const std::string&, Need)>
TetMesh read_with(const fs::path& path, Need need) {
  return parse(read_file(path), path.string(), need);
}

struct PointFormat {
  const char* name;
  const char* extension;
  PointSet (*parse)(std::string_view, const std::string&);
};
constexpr std::array kPointFormats{
    PointFormat{"xyz", ".xyz", &parse_xyz},
    PointFormat{"csv", ".csv", &parse_csv},
    PointFormat{"pqr", ".pqr", &parse_pqr},
    PointFormat{"node", ".node", &parse_node},
};

struct TetMeshFormat {
  const char* name;
  std::array<const char*, 3> extensions;  // the first format of an extension is its default for writing
  TetMesh (*read)(const fs::path&, Need);
  void (*write)(const fs::path&, const TetMesh&, const WriteOptions&);
  bool has_ascii_option;
};
constexpr std::array kTetMeshFormats{
    TetMeshFormat{"vtu",
                  {".vtu", "", ""},
                  &read_with<parse_vtu>,
                  [](const fs::path& path, const TetMesh& mesh, const WriteOptions& options) {
                    write_vtu(path, mesh, options.min_dihedral_deg);
                  },
                  false},
    TetMeshFormat{"msh22",
                  {".msh", "", ""},
                  &read_with<parse_msh>,
                  [](const fs::path& path, const TetMesh& mesh, const WriteOptions& options) {
                    write_msh22(path, mesh, options.ascii);
                  },
                  true},
    TetMeshFormat{"msh41",
                  {".msh", "", ""},
                  &read_with<parse_msh>,
                  [](const fs::path& path, const TetMesh& mesh, const WriteOptions& options) {
                    write_msh41(path, mesh, options.ascii);
                  },
                  true},
    TetMeshFormat{
        "medit",
        {".mesh", "", ""},
        &read_with<parse_medit>,
        [](const fs::path& path, const TetMesh& mesh, const WriteOptions&) { write_medit(path, mesh); },
        false},
    TetMeshFormat{
        "tetgen",
        {".node", ".ele", ".face"},
        &read_tetgen,
        [](const fs::path& path, const TetMesh& mesh, const WriteOptions&) { write_tetgen(path, mesh); },
        false},
};

template <class Formats>
std::vector<std::string> names_of(const Formats& formats) {
  std::vector<std::string> names;
  for (const auto& format : formats) names.emplace_back(format.name);
  return names;
}

bool has_extension(const TetMeshFormat& format, const std::string& extension) {
  return !extension.empty() && std::count(format.extensions.begin(), format.extensions.end(), extension) > 0;
}

/// What a file with this extension is; empty if it is nothing that is read here.
std::string_view kind_of(const std::string& extension) {
  for (const SurfaceFormat& format : kSurfaceFormats)
    if (extension == format.extension) return "surface";
  for (const TetMeshFormat& format : kTetMeshFormats)
    if (has_extension(format, extension)) return "tetrahedral mesh";
  for (const PointFormat& format : kPointFormats)
    if (extension == format.extension) return "file of points";
  return {};
}

[[noreturn]] void fail_unknown_extension(const fs::path& path, std::string_view wanted,
                                         std::string_view known) {
  const std::string extension = extension_of(path);
  const std::string_view kind = kind_of(extension);
  const std::string is = kind.empty() ? "no extension" : fmt::format("the extension of a {}, not", kind);
  fail(ErrorCode::kUnsupported, "'{}': {} is {} of a {}; known are {}", path.string(),
       extension.empty() ? "none" : "'" + extension + "'", is, wanted, known);
}

const TetMeshFormat& format_by_extension(const fs::path& path) {
  const std::string extension = extension_of(path);
  for (const TetMeshFormat& format : kTetMeshFormats)
    if (has_extension(format, extension)) return format;
  fail_unknown_extension(path, "tetrahedral mesh", ".vtu, .msh, .mesh, .node, .ele and .face");
}

const TetMeshFormat& format_by_name(const std::string& name) {
  for (const TetMeshFormat& format : kTetMeshFormats)
    if (format.name == name) return format;
  fail(ErrorCode::kBadOption, "'{}' is no format of a tetrahedral mesh; known are {}", name,
       fmt::join(tet_mesh_formats(), ", "));
}

// The vertices of a mesh, whichever its kind; nothing when the extension is none of a mesh.
std::optional<std::vector<Vec3>> read_vertices(const fs::path& path) {
  const std::string extension = extension_of(path);
  for (const SurfaceFormat& format : kSurfaceFormats)
    if (extension == format.extension)
      return format.parse(read_file(path), path.string(), Need::kPoints).points;
  for (const TetMeshFormat& format : kTetMeshFormats)
    if (has_extension(format, extension)) return format.read(path, Need::kPoints).points;
  return std::nullopt;
}

NodalField read_medit_field(const fs::path& path) {
  const fs::path mesh_path = fs::path(path).replace_extension(".mesh");
  const fs::path sol_path = fs::path(path).replace_extension(".sol");
  NodalField field{read_tet_mesh(mesh_path), {}};
  field.values = parse_sol(read_file(sol_path), sol_path.string(), field.mesh.points.size());
  return field;
}

NodalField read_tetgen_field(const fs::path& path) {
  const fs::path mtr_path = fs::path(path).replace_extension(".mtr");
  NodalField field{read_tetgen(path, Need::kElements), {}};
  field.values = parse_mtr(read_file(mtr_path), mtr_path.string(), field.mesh.points.size());
  return field;
}

}  // namespace

TriangleMesh read_surface(const fs::path& path) {
  const std::string extension = extension_of(path);
  for (const SurfaceFormat& format : kSurfaceFormats)
    if (extension == format.extension) return format.parse(read_file(path), path.string(), Need::kElements);
  fail_unknown_extension(path, "surface", ".stl, .obj, .off and .ply");
}

TetMesh read_tet_mesh(const fs::path& path) { return format_by_extension(path).read(path, Need::kElements); }

void write_tet_mesh(const fs::path& path, const TetMesh& mesh, const WriteOptions& options) {
  const TetMeshFormat& format =
      options.format.empty() ? format_by_extension(path) : format_by_name(options.format);
  if (options.ascii && !format.has_ascii_option)
    fail(ErrorCode::kBadOption, "format {} has no choice of text; leave 'ascii' out", format.name);
  if (!options.min_dihedral_deg.empty() && options.min_dihedral_deg.size() != mesh.tets.size())
    fail(ErrorCode::kBadOption, "{} values of min_dihedral_deg are given for {} tetrahedra",
         options.min_dihedral_deg.size(), mesh.tets.size());
  require_consistent(mesh);
  format.write(path, mesh, options);
}

NodalField read_sizing_mesh(const fs::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".mesh" || extension == ".sol") return read_medit_field(path);
  if (extension == ".node" || extension == ".ele" || extension == ".mtr") return read_tetgen_field(path);
  fail_unknown_extension(path, "sizing mesh", ".mesh (with .sol) and .node or .ele (with .mtr)");
}

PointSet read_points(const fs::path& path) {
  const std::string extension = extension_of(path);
  for (const PointFormat& format : kPointFormats)
    if (extension == format.extension) return format.parse(read_file(path), path.string());
  std::optional<std::vector<Vec3>> vertices = read_vertices(path);
  if (!vertices)
    fail_unknown_extension(path, "file of points",
                           ".xyz, .csv, .pqr and .node, and those of surfaces (.stl, .obj, .off, .ply) and "
                           "tetrahedral meshes (.vtu, .msh, .mesh, .ele)");
  PointSet set{std::move(*vertices), {}, {}};
  require_points(set, path.string());
  return set;
}

std::vector<std::string> surface_formats() { return names_of(kSurfaceFormats); }
std::vector<std::string> tet_mesh_formats() { return names_of(kTetMeshFormats); }
std::vector<std::string> point_formats() { return names_of(kPointFormats); }

}  // namespace unsliver::io
