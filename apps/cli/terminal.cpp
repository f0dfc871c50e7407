#include "terminal.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace unsliver::cli {

void print_result(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

bool results_arrived() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  say_error(std::string("the results could not be written to standard output: ") + std::strerror(errno));
  return false;
}

void say(const std::string& message) { std::fprintf(stderr, "unsliver: %s\n", message.c_str()); }
void say_warning(const std::string& message) { say("warning: " + message); }
void say_error(const std::string& message) { say("error: " + message); }

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

}  // namespace unsliver::cli
