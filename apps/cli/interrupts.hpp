/// \file
/// Ctrl-C and SIGTERM: a flag that the library polls, and a way out when nobody polls in time.
#pragma once

namespace unsliver::cli::interrupts {

/// Installs the handlers. A file size limit becomes a failed write instead of a death.
void install();

/// Has the user asked to stop?
bool requested();

/// While one of these lives, a first signal sets the flag and no more. At all other times the program leaves
/// within 80 ms of the signal by force if it has not left by itself; no file is open for writing then.
class Hold {
 public:
  enum class For {
    kOutcome,  ///< the mesh so far or the report is wanted; a second signal leaves all the same
    kFile,     ///< a file is being written: it is finished whatever comes
  };
  explicit Hold(For purpose);
  ~Hold();
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

 private:
  For purpose_;
};

}  // namespace unsliver::cli::interrupts
