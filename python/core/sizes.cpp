#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "formula_error.hpp"
#include "geometry.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::python {
namespace {

SizeObject nodal(const py::handle& mesh, const py::handle& values) {
  NodalField field{to_tet_mesh(mesh), {}};
  field.values = to_numbers(values, "values", field.mesh.points.size());
  const py::gil_scoped_release unlocked;
  return {background_size(std::move(field))};
}

SizeObject expression(const std::string& text, const py::handle& lo, const py::handle& hi) {
  const Box3 bounds{to_point(lo, "lo"), to_point(hi, "hi")};
  return {cli::of_formula("size", text, [&](const std::string& t) { return expression_size(t, bounds); })};
}

/// Sampled at once, in this thread: the callable is not needed afterwards.
SizeObject sampled(const py::function& f, const py::handle& lo, const py::handle& hi, std::size_t samples) {
  const auto values_at = [&f](const std::vector<Vec3>& points) {
    std::vector<Vec3> copy = points;
    return to_numbers(f(array_of<double>(std::move(copy))), "the size function's result", points.size());
  };
  return {sampled_size_at_once(values_at, {to_point(lo, "lo"), to_point(hi, "hi")}, samples)};
}

py::array sizes_at(const SizeObject& size, const py::handle& points) {
  const std::vector<Vec3> places = to_points(points, "points");
  std::vector<double> values;
  {
    const py::gil_scoped_release unlocked;
    for (const Vec3& p : places) values.push_back(size.sizing->at(p));
  }
  return array_of<double>(std::move(values));
}

}  // namespace

void add_sizes(py::module_& module) {
  py::class_<SizeObject>(module, "Sizing")
      .def("__call__", sizes_at, py::arg("points"))
      .def_property_readonly("lipschitz", [](const SizeObject& size) { return size.sizing->lipschitz(); })
      .def_property_readonly("notes", [](const SizeObject& size) { return size.sizing->notes(); })
      .def("__repr__", [](const SizeObject& size) {
        return fmt::format("<unsliver.Sizing: {}>", size.sizing->describe());
      });
  module.def("expression_size", expression, py::arg("expression"), py::arg("lo"), py::arg("hi"));
  module.def("nodal_size", nodal, py::arg("mesh"), py::arg("values"));
  module.def("sampled_size", sampled, py::arg("f"), py::arg("lo"), py::arg("hi"), py::kw_only(),
             py::arg("samples") = 1'000'000);
}

}  // namespace unsliver::python
