#include "errors.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "unsliver/error.hpp"

namespace unsliver::python {
namespace {

bool is_lower(char c) { return 'a' <= c && c <= 'z'; }

void raise(const Error& error) {
  const py::object classes = py::module_::import("unsliver._errors").attr("CLASSES");
  const py::object type = classes[py::str(to_string(error.code()))];
  std::vector<Vec3> places = error.places;
  const py::object raised = type(with_keywords(error.what()), error.ids, array_of<double>(std::move(places)));
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

std::string with_keywords(const std::string& message) {
  std::string text;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const bool option = message.compare(i, 2, "--") == 0 && i + 2 < message.size() &&
                        is_lower(message[i + 2]) &&
                        (i == 0 || message[i - 1] == ' ' || message[i - 1] == '(');
    if (!option) {
      text += message[i];
      continue;
    }
    for (i += 2; i < message.size() && (is_lower(message[i]) || message[i] == '-'); ++i)
      text += message[i] == '-' ? '_' : message[i];
    --i;
  }
  return text;
}

void register_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace unsliver::python
