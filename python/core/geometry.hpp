/// \file
/// Domains and sizing functions as Python objects.
#pragma once

#include <pybind11/pybind11.h>

#include "domain_source.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::python {

/// What Python holds. Immutable.
struct DomainObject {
  cli::DomainSource source;
};
struct SizeObject {
  SizingPtr sizing;
};

void add_domains(pybind11::module_& module);
void add_sizes(pybind11::module_& module);

}  // namespace unsliver::python
