/// \file
/// unsliver._core: what the Python package `unsliver` is made of. Not for use by itself: _core.pyi has the
/// signatures, the package the documentation.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "geometry.hpp"
#include "jobs.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/io.hpp"
#include "unsliver/quality.hpp"

namespace unsliver::python {
namespace {

template <typename Read>
auto unlocked(Read read) {
  const py::gil_scoped_release unlocked;
  return read();
}

py::dict read_tet_mesh(const std::filesystem::path& path) {
  cli::check_readable(path);
  return from_tet_mesh(unlocked([&] { return io::read_tet_mesh(path); }));
}

py::dict read_surface(const std::filesystem::path& path) {
  cli::check_readable(path);
  TriangleMesh surface = unlocked([&] { return io::read_surface(path); });
  surface.name = path.string();
  return from_surface(std::move(surface));
}

py::tuple read_points(const std::filesystem::path& path) {
  cli::check_readable(path);
  PointSet set = unlocked([&] { return io::read_points(path); });
  const py::object sizes =
      set.sizes.empty() ? py::object(py::none()) : py::object(array_of<double>(std::move(set.sizes)));
  return py::make_tuple(array_of<double>(std::move(set.points)), sizes, set.notes);
}

void write(const std::filesystem::path& path, const py::handle& mesh, const std::string& format, bool ascii) {
  const TetMesh tets = to_tet_mesh(mesh);
  const py::gil_scoped_release unlocked;
  cli::check_mesh_output(path, format);
  io::WriteOptions options{.format = format, .ascii = ascii, .min_dihedral_deg = {}};
  if (format == "vtu" || (format.empty() && cli::extension_of(path) == "vtu"))
    options.min_dihedral_deg = min_dihedral_angles_deg(tets);
  io::write_tet_mesh(path, tets, options);
}

py::array boundary_faces(const py::handle& mesh) {
  return array_of<VertexId>(boundary_facets(to_tet_mesh(mesh)));
}

void add_files(py::module_& module) {
  module.def("read_tet_mesh", read_tet_mesh);
  module.def("read_surface", read_surface);
  module.def("read_points", read_points);
  module.def("write", write);
  module.def("is_surface_file", cli::is_surface_file);
  module.def("is_tet_mesh_file", cli::is_tet_mesh_file);
}

void add_checks(py::module_& module) {
  module.def("validate_mesh", [](const py::handle& mesh) { to_tet_mesh(mesh); });
  module.def("validate_surface", [](const py::handle& surface) { to_surface(surface); });
  module.def("boundary_faces", boundary_faces);
}

}  // namespace
}  // namespace unsliver::python

PYBIND11_MODULE(_core, module) {
  using namespace unsliver::python;
  register_errors();
  add_domains(module);
  add_sizes(module);
  add_jobs(module);
  add_files(module);
  add_checks(module);
}
