#include "report/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace cellsweep::report {
namespace {

constexpr std::chrono::milliseconds kPause{100};

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      on_terminal_(isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + kPause) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done) {
  if (!on_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + kPause;
  shown_ = true;
  std::fprintf(stderr, "\r\033[K%s: %zu", what_.c_str(), done);
  if (total_ != kOpenEnd) std::fprintf(stderr, " of %zu", total_);
  std::fflush(stderr);
}

}  // namespace cellsweep::report
