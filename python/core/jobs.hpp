/// \file
/// Meshing, refining and judging.
#pragma once

#include <pybind11/pybind11.h>

namespace unsliver::python {

void add_jobs(pybind11::module_& module);

}  // namespace unsliver::python
