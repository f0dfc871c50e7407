#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "formula_error.hpp"
#include "geometry.hpp"
#include "text.hpp"
#include "unsliver/hull.hpp"

namespace unsliver::python {
namespace {

using cli::DomainSource;

Box3 to_box(const py::handle& lo, const py::handle& hi) { return {to_point(lo, "lo"), to_point(hi, "hi")}; }

DomainObject box(const py::handle& lo, const py::handle& hi, bool conform) {
  const Box3 box = to_box(lo, hi);
  DomainSource source{.kind = "box", .label = "box " + cli::box_text(box), .domain = make_box(box)};
  if (conform) {
    source.label += ", filled exactly";
    source.exact_box = box;
  }
  return {std::move(source)};
}

DomainObject ball(const py::handle& center, double radius) {
  const Vec3 c = to_point(center, "center");
  return {{.kind = "ball",
           .label = fmt::format("ball {} radius {}", cli::point_text(c), radius),
           .domain = make_ball(c, radius)}};
}

DomainObject implicit(const std::string& expression, const py::handle& lo, const py::handle& hi) {
  const Box3 bounds = to_box(lo, hi);
  const auto make = [&](const std::string& text) {
    const py::gil_scoped_release unlocked;
    return make_implicit(text, bounds);
  };
  return {{.kind = "implicit",
           .label = expression + " <= 0",
           .domain = cli::of_formula("expression", expression, make)}};
}

DomainObject of_surface(const py::handle& surface) {
  TriangleMesh triangles = to_surface(surface);
  const std::string label = triangles.name;
  const py::gil_scoped_release unlocked;
  return {cli::source_of_surface(std::move(triangles), label)};
}

DomainObject of_tets(const py::handle& mesh, const std::string& label) {
  const TetMesh tets = to_tet_mesh(mesh);
  if (tets.tets.empty()) throw Error(ErrorCode::kBadInput, label + ": there is no tetrahedron");
  const py::gil_scoped_release unlocked;
  return {cli::source_of_tets(tets, label)};
}

DomainObject around_points(const py::handle& points, bool hull) {
  const cli::InputVertices inputs{"points", {to_points(points, "points"), {}, {}}, {}};
  if (inputs.count() == 0) throw Error(ErrorCode::kBadInput, "points: there are none");
  const py::gil_scoped_release unlocked;
  return {cli::source_around(inputs, hull)};
}

py::array contains(const DomainObject& domain, const py::handle& points) {
  const std::vector<Vec3> places = to_points(points, "points");
  std::vector<std::uint8_t> inside;
  {
    const py::gil_scoped_release unlocked;
    for (const Vec3& p : places) inside.push_back(domain.source.domain->contains(p) ? 1 : 0);
  }
  return array_of<std::uint8_t>(std::move(inside)).attr("view")("bool");
}

py::tuple bounds(const DomainObject& domain) {
  const Box3 box = domain.source.domain->bounds();
  return py::make_tuple(py::make_tuple(box.lo.x, box.lo.y, box.lo.z),
                        py::make_tuple(box.hi.x, box.hi.y, box.hi.z));
}

}  // namespace

void add_domains(py::module_& module) {
  py::class_<DomainObject>(module, "Domain")
      .def_property_readonly("kind", [](const DomainObject& domain) { return domain.source.kind; })
      .def_property_readonly("bounds", bounds)
      .def_property_readonly("volume",
                             [](const DomainObject& domain) { return domain.source.domain->volume(); })
      .def_property_readonly("notes", [](const DomainObject& domain) { return all_notes(domain.source); })
      .def("contains", contains, py::arg("points"))
      .def("__repr__", [](const DomainObject& domain) {
        return fmt::format("<unsliver.Domain: {}>", domain.source.domain->describe());
      });
  module.def("box", box, py::arg("lo"), py::arg("hi"), py::kw_only(), py::arg("conform") = false);
  module.def("ball", ball, py::arg("center"), py::arg("radius"));
  module.def("implicit", implicit, py::arg("expression"), py::arg("lo"), py::arg("hi"));
  module.def("domain_of_surface", of_surface);
  module.def("domain_of_tets", of_tets);
  module.def("domain_around_points", around_points, py::arg("points"), py::arg("hull"));
}

}  // namespace unsliver::python
