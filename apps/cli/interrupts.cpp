#include "interrupts.hpp"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>

#include "exit_code.hpp"

namespace unsliver::cli::interrupts {
namespace {

constexpr int kGraceMicroseconds = 80'000;

std::atomic<bool> stop_requested{false};
std::atomic<int> files_held{0}, meshes_held{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "signal handlers may touch lock-free atomics only");

void arm_timer(int microseconds) {
  const itimerval once{{0, 0}, {0, microseconds}};
  setitimer(ITIMER_REAL, &once, nullptr);
}

void on_interrupt(int) {
  const bool again = stop_requested.exchange(true);
  if (files_held == 0 && (meshes_held == 0 || again)) arm_timer(kGraceMicroseconds);
}

void on_grace_over(int) {
  if (files_held != 0) return;
  constexpr char kMessage[] = "\nunsliver: interrupted; nothing was written\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
  _exit(static_cast<int>(ExitCode::kLimit));
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install() {
  handle(SIGINT, on_interrupt);
  handle(SIGTERM, on_interrupt);
  handle(SIGALRM, on_grace_over);
  handle(SIGXFSZ, SIG_IGN);
}

bool requested() { return stop_requested; }

Hold::Hold(For purpose) : purpose_(purpose) {
  ++(purpose_ == For::kFile ? files_held : meshes_held);
  arm_timer(0);
}

Hold::~Hold() {
  --(purpose_ == For::kFile ? files_held : meshes_held);
  if (files_held == 0 && meshes_held == 0 && requested()) arm_timer(kGraceMicroseconds);
}

}  // namespace unsliver::cli::interrupts
