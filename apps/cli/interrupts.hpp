/// \file
/// Ctrl-C and SIGTERM: a flag that the library polls, and a way out when nobody polls in time.
#pragma once

namespace unsliver::cli::interrupts {

/// Installs the handlers. A file size limit becomes a failed write instead of a death.
void install();

/// Has the user asked to stop?
bool requested();

/// While one of these lives, a signal sets the flag and nothing else: a file is being written, or the mesh so
/// far is wanted. At all other times the program leaves within 80 ms of the signal by force if it has not
/// left by itself; no file is open for writing then.
class Finish {
 public:
  Finish();
  ~Finish();
  Finish(const Finish&) = delete;
  Finish& operator=(const Finish&) = delete;
};

}  // namespace unsliver::cli::interrupts
