/// \file
/// Shows where in a formula a mistake is.
#pragma once

#include <string>

#include "unsliver/error.hpp"

namespace unsliver::cli {

/// `error`, which names a column of `formula`, as typed for `option`: with the option's name, and the formula
/// on a line of its own (cut where it is long) with a caret under the column.
Error with_caret(const std::string& option, const std::string& formula, const Error& error);

/// What `make` makes of the formula. \throws Error, with a caret.
template <typename Make>
auto of_formula(const std::string& option, const std::string& formula, Make make) {
  try {
    return make(formula);
  } catch (const Error& error) {
    throw with_caret(option, formula, error);
  }
}

}  // namespace unsliver::cli
