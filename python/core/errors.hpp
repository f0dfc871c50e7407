/// \file
/// The library's errors as Python exceptions.
#pragma once

#include <string>

namespace unsliver::python {

/// From now on an Error is raised as the class that unsliver._errors.CLASSES names for its code.
void register_errors();

/// Messages written for the command line, with its options as the keyword arguments that they are here:
/// "--max-tets" becomes "max_tets".
std::string with_keywords(const std::string& message);

}  // namespace unsliver::python
