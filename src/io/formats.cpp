/// \file
/// The public face: which extension goes to which reader and writer.
#include <algorithm>
#include <array>
#include <system_error>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/file_bytes.hpp"
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
  TriangleMesh (*parse)(std::string_view, const std::string&);
};
constexpr std::array kSurfaceFormats{
    SurfaceFormat{"stl", ".stl", &parse_stl},
    SurfaceFormat{"obj", ".obj", &parse_obj},
    SurfaceFormat{"off", ".off", &parse_off},
    SurfaceFormat{"ply", ".ply", &parse_ply},
};

TetMesh read_tetgen(const fs::path& path) {
  const auto sibling = [&](const char* extension) { return fs::path(path).replace_extension(extension); };
  const std::string node = read_file(sibling(".node"));
  const std::string ele = read_file(sibling(".ele"));
  std::error_code ignored;
  const std::string face = fs::exists(sibling(".face"), ignored) ? read_file(sibling(".face")) : "";
  return parse_tetgen({node, ele, face}, sibling("").string());
}

template <TetMesh (*parse)(std::string_view, const std::string&)>
TetMesh read_with(const fs::path& path) {
  return parse(read_file(path), path.string());
}

struct TetMeshFormat {
  const char* name;
  std::array<const char*, 3> extensions;  // the first format of an extension is its default for writing
  TetMesh (*read)(const fs::path&);
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

[[noreturn]] void fail_unknown_extension(const fs::path& path, const char* kind, std::string_view known) {
  const std::string extension = extension_of(path);
  fail(ErrorCode::kUnsupported, "'{}': {} is no extension of a {}; known are {}", path.string(),
       extension.empty() ? "none" : "'" + extension + "'", kind, known);
}

const TetMeshFormat& format_by_extension(const fs::path& path) {
  const std::string extension = extension_of(path);
  for (const TetMeshFormat& format : kTetMeshFormats)
    if (!extension.empty() && std::count(format.extensions.begin(), format.extensions.end(), extension) > 0)
      return format;
  fail_unknown_extension(path, "tetrahedral mesh", ".vtu, .msh, .mesh, .node, .ele and .face");
}

const TetMeshFormat& format_by_name(const std::string& name) {
  for (const TetMeshFormat& format : kTetMeshFormats)
    if (format.name == name) return format;
  fail(ErrorCode::kBadOption, "'{}' is no format of a tetrahedral mesh; known are {}", name,
       fmt::join(tet_mesh_formats(), ", "));
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
  NodalField field{read_tetgen(path), {}};
  field.values = parse_mtr(read_file(mtr_path), mtr_path.string(), field.mesh.points.size());
  return field;
}

}  // namespace

TriangleMesh read_surface(const fs::path& path) {
  const std::string extension = extension_of(path);
  for (const SurfaceFormat& format : kSurfaceFormats)
    if (extension == format.extension) return format.parse(read_file(path), path.string());
  fail_unknown_extension(path, "surface", ".stl, .obj, .off and .ply");
}

TetMesh read_tet_mesh(const fs::path& path) { return format_by_extension(path).read(path); }

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

std::vector<std::string> surface_formats() { return names_of(kSurfaceFormats); }
std::vector<std::string> tet_mesh_formats() { return names_of(kTetMeshFormats); }

}  // namespace unsliver::io
