/// \file
/// Results go to stdout, everything said to a person beside them to stderr.
#pragma once

#include <string>

namespace unsliver::cli {

/// Prints a result to stdout.
void print_result(const std::string& text);
/// Flushes stdout and tells whether everything printed arrived; says so on stderr when it did not (a full
/// disk behind a redirection).
bool results_arrived();

/// "unsliver: ..." on stderr, one line each.
void say(const std::string& message);
void say_warning(const std::string& message);
void say_error(const std::string& message);

bool stderr_is_terminal();

}  // namespace unsliver::cli
