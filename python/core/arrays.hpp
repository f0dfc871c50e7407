/// \file
/// Between numpy arrays and the library's vectors. All functions here need the interpreter lock.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::python {

namespace py = pybind11;

/// A numpy array that owns what was the vector's memory: shape (n,), or (n, width) where an element consists
/// of `width` > 1 scalars.
template <typename Scalar, typename Element>
py::array array_of(std::vector<Element>&& elements) {
  constexpr py::ssize_t kWidth = sizeof(Element) / sizeof(Scalar);
  const auto count = static_cast<py::ssize_t>(elements.size());
  auto owner = std::make_unique<std::vector<Element>>(std::move(elements));
  const auto* data = reinterpret_cast<const Scalar*>(owner->data());
  const py::capsule keeper(owner.get(), [](void* p) { delete static_cast<std::vector<Element>*>(p); });
  owner.release();
  std::vector<py::ssize_t> shape = {count};
  if (kWidth > 1) shape.push_back(kWidth);
  return py::array_t<Scalar>(shape, data, keeper);
}

/// The elements of an array (n,) or (n, width), converted. `name` is what messages call it.
/// \throws Error kBadInput for another shape or a type that cannot be converted without loss.
std::vector<Vec3> to_points(const py::handle& array, const std::string& name);  ///< finite, too
std::vector<double> to_numbers(const py::handle& array, const std::string& name, std::size_t count);
Vec3 to_point(const py::handle& array, const std::string& name);

/// From a Python `Mesh` or `Surface`, whose arrays may have been changed since it was made: shapes and
/// indices are checked. \throws Error kBadInput naming the first elements at fault.
TetMesh to_tet_mesh(const py::handle& mesh);
TriangleMesh to_surface(const py::handle& surface);

/// Keyword arguments for a Python `Mesh` or `Surface`.
py::dict from_tet_mesh(TetMesh&& mesh);
py::dict from_surface(TriangleMesh&& surface);

}  // namespace unsliver::python
