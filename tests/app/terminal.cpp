#include "terminal.h"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>

#include "base/text.h"

namespace cellsweep::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongEnough{60};
constexpr int kPollMilliseconds = 100;

}  // namespace

OnTerminal::OnTerminal(const std::string& arguments, const std::string& output_file) {
  const std::string line = text("exec ", CELLSWEEP_COMMAND, " ", arguments, " >", output_file);
  process_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
  if (process_ != 0) return;
  std::signal(SIGINT, SIG_DFL);
  execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
  _exit(127);
}

OnTerminal::~OnTerminal() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(terminal_);
}

// False when there will be no more. A terminal whose other side is closed fails to be read.
bool OnTerminal::read_more() {
  pollfd waiting{terminal_, POLLIN, 0};
  if (poll(&waiting, 1, kPollMilliseconds) == 0) return true;
  std::array<char, 4096> part{};
  const ssize_t bytes = read(terminal_, part.data(), part.size());
  if (bytes <= 0) return false;
  shown_.append(part.data(), static_cast<std::size_t>(bytes));
  return true;
}

bool OnTerminal::wait_for(const std::string& words) {
  const Clock::time_point end = Clock::now() + kLongEnough;
  while (shown_.find(words) == std::string::npos) {
    if (Clock::now() > end || !read_more()) return false;
  }
  return true;
}

void OnTerminal::press_ctrl_c() const {
  constexpr char kKey = 3;
  [[maybe_unused]] const ssize_t written = write(terminal_, &kKey, 1);
}

void OnTerminal::terminate() const {
  kill(process_, SIGTERM);
}

int OnTerminal::exit_code() {
  while (read_more()) {
  }
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace cellsweep::app
