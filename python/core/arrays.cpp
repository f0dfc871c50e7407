#include "arrays.hpp"

#include <fmt/format.h>

#include <utility>

#include "unsliver/error.hpp"

namespace unsliver::python {
namespace {

constexpr std::size_t kShown = 10;

/// Numbers of a kind that numpy's "safe" casts allow; integers of any width are read as int64 first.
template <typename Scalar>
py::array_t<Scalar, py::array::c_style> converted(const py::handle& array, const std::string& name,
                                                  const char* wanted) {
  try {
    const py::module_ numpy = py::module_::import("numpy");
    const py::object plain = numpy.attr("asarray")(array);
    const bool empty = plain.attr("size").cast<std::size_t>() == 0;
    const py::object cast =
        plain.attr("astype")(py::dtype::of<Scalar>(), py::arg("order") = "C",
                             py::arg("casting") = empty ? "unsafe" : "same_kind", py::arg("copy") = false);
    return cast.cast<py::array_t<Scalar, py::array::c_style>>();
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw;
    throw Error(ErrorCode::kBadInput, fmt::format("{}: {} are needed ({})", name, wanted, error.what()));
  }
}

void require_shape(const py::array& array, const std::string& name, py::ssize_t width) {
  const bool flat = width == 1;
  if (array.ndim() == (flat ? 1 : 2) && (flat || array.shape(1) == width)) return;
  throw Error(ErrorCode::kBadInput, fmt::format("{}: an array of shape {} is needed, this has {}", name,
                                                flat ? "(n,)" : fmt::format("(n, {})", width),
                                                py::str(array.attr("shape")).cast<std::string>()));
}

template <typename Scalar, typename Element = Scalar>
std::vector<Element> elements_of(const py::handle& array, const std::string& name, const char* wanted) {
  const auto numbers = converted<Scalar>(array, name, wanted);
  if (numbers.size() == 0) return {};
  require_shape(numbers, name, sizeof(Element) / sizeof(Scalar));
  const auto* first = reinterpret_cast<const Element*>(numbers.data());
  return {first, first + numbers.shape(0)};
}

/// Integers, by way of 64 bits so that none is wrapped into the range.
template <typename Scalar>
std::vector<Scalar> optional_elements(const py::handle& owner, const char* name, std::size_t count) {
  const py::object array = owner.attr(name);
  if (array.is_none()) return {};
  std::vector<Scalar> elements;
  for (const std::int64_t wide : elements_of<std::int64_t>(array, name, "integers")) {
    if (!std::in_range<Scalar>(wide))
      throw Error(ErrorCode::kBadInput, fmt::format("{}: {} is out of range", name, wide));
    elements.push_back(static_cast<Scalar>(wide));
  }
  if (elements.size() == count) return elements;
  throw Error(ErrorCode::kBadInput,
              fmt::format("{}: {} entries are needed, this has {}", name, count, elements.size()));
}

template <std::size_t kCorners>
std::vector<std::array<VertexId, kCorners>> simplices_of(const py::handle& array, const std::string& name,
                                                         std::size_t points) {
  using Wide = std::array<std::int64_t, kCorners>;
  std::vector<std::array<VertexId, kCorners>> simplices;
  Error error(ErrorCode::kBadInput, "");
  std::int64_t id = 0;
  for (const Wide& wide : elements_of<std::int64_t, Wide>(array, name, "integers")) {
    auto& simplex = simplices.emplace_back();
    bool valid = true;
    for (std::size_t i = 0; i < kCorners; ++i) {
      valid &= wide[i] >= 0 && wide[i] < static_cast<std::int64_t>(points);
      simplex[i] = static_cast<VertexId>(wide[i]);
    }
    if (!valid && error.ids.size() < kShown) error.ids.push_back(id);
    ++id;
  }
  if (error.ids.empty()) return simplices;
  Error told(ErrorCode::kBadInput, fmt::format("{}: row {} has an index outside of 0 to {}", name,
                                               error.ids.front(), static_cast<std::int64_t>(points) - 1));
  told.ids = error.ids;
  throw told;
}

void require_finite(const std::vector<Vec3>& points, const std::string& name) {
  std::vector<std::int64_t> ids;
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < points.size() && ids.size() < kShown; ++i) {
    if (is_finite(points[i])) continue;
    ids.push_back(static_cast<std::int64_t>(i));
    places.push_back(points[i]);
  }
  if (ids.empty()) return;
  const Vec3& p = places.front();
  Error error(ErrorCode::kBadInput, fmt::format("{}: point {} is ({}, {}, {}), but all must be finite", name,
                                                ids.front(), p.x, p.y, p.z));
  error.ids = ids;
  error.places = places;
  throw error;
}

/// Those of kCount numbers, or none.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> optional_numbers(const py::handle& owner, const char* name) {
  const py::object value = owner.attr(name);
  if (value.is_none()) return std::nullopt;
  std::array<double, kCount> numbers{};
  const std::vector<double> given = to_numbers(value, name, kCount);
  std::copy(given.begin(), given.end(), numbers.begin());
  return numbers;
}

py::object none_if_empty(py::array&& array) {
  if (array.size() == 0) return py::none();
  return std::move(array);
}

}  // namespace

std::vector<Vec3> to_points(const py::handle& array, const std::string& name) {
  auto points = elements_of<double, Vec3>(array, name, "numbers");
  if (points.size() >= kNoVertex)
    throw Error(ErrorCode::kUnsupported, name + ": there are 2^32 - 1 points or more");
  require_finite(points, name);
  return points;
}

std::vector<double> to_numbers(const py::handle& array, const std::string& name, std::size_t count) {
  auto numbers = elements_of<double>(array, name, "numbers");
  if (numbers.size() == count) return numbers;
  throw Error(ErrorCode::kBadInput,
              fmt::format("{}: {} numbers are needed, these are {}", name, count, numbers.size()));
}

Vec3 to_point(const py::handle& array, const std::string& name) {
  const std::vector<double> n = to_numbers(array, name, 3);
  return {n[0], n[1], n[2]};
}

TetMesh to_tet_mesh(const py::handle& mesh) {
  TetMesh result;
  result.points = to_points(mesh.attr("points"), "points");
  const std::size_t n = result.points.size();
  result.tets = simplices_of<4>(mesh.attr("tets"), "tets", n);
  result.triangles = simplices_of<3>(mesh.attr("faces"), "faces", n);
  result.regions = optional_elements<std::int32_t>(mesh, "regions", result.tets.size());
  result.triangle_labels = optional_elements<std::int32_t>(mesh, "face_markers", result.triangles.size());
  result.levels = optional_elements<std::uint8_t>(mesh, "levels", n);
  result.point_source = optional_elements<std::int64_t>(mesh, "point_source", n);
  if (const auto f = optional_numbers<4>(mesh, "frame"))
    result.frame = Frame{(*f)[0], {(*f)[1], (*f)[2], (*f)[3]}};
  if (const auto l = optional_numbers<3>(mesh, "limits"))
    result.limits = QualityLimits{(*l)[0], (*l)[1], (*l)[2]};
  return result;
}

TriangleMesh to_surface(const py::handle& surface) {
  TriangleMesh result;
  result.points = to_points(surface.attr("points"), "points");
  result.triangles = simplices_of<3>(surface.attr("triangles"), "triangles", result.points.size());
  result.name = surface.attr("name").cast<std::string>();
  return result;
}

py::dict from_tet_mesh(TetMesh&& mesh) {
  py::dict arrays;
  arrays["points"] = array_of<double>(std::move(mesh.points));
  arrays["tets"] = array_of<VertexId>(std::move(mesh.tets));
  arrays["faces"] = array_of<VertexId>(std::move(mesh.triangles));
  arrays["regions"] = none_if_empty(array_of<std::int32_t>(std::move(mesh.regions)));
  arrays["face_markers"] = none_if_empty(array_of<std::int32_t>(std::move(mesh.triangle_labels)));
  arrays["levels"] = none_if_empty(array_of<std::uint8_t>(std::move(mesh.levels)));
  arrays["point_source"] = none_if_empty(array_of<std::int64_t>(std::move(mesh.point_source)));
  if (const auto& f = mesh.frame)
    arrays["frame"] = py::make_tuple(f->unit, f->origin.x, f->origin.y, f->origin.z);
  if (const auto& l = mesh.limits)
    arrays["limits"] = py::make_tuple(l->min_dihedral_deg, l->max_dihedral_deg, l->max_radius_edge);
  return arrays;
}

py::dict from_surface(TriangleMesh&& surface) {
  py::dict arrays;
  arrays["points"] = array_of<double>(std::move(surface.points));
  arrays["triangles"] = array_of<VertexId>(std::move(surface.triangles));
  arrays["name"] = surface.name;
  return arrays;
}

}  // namespace unsliver::python
