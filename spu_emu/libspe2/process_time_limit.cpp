#include "libspe2/process_time_limit.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "spe/process_report.h"

namespace spu_emu {

namespace {
constexpr int kOutOfTime = 124;
constexpr double kMostSeconds = 365.0 * 24 * 3600;

double seconds_in(const char* text) {
  char* end = nullptr;
  const double seconds = std::strtod(text, &end);
  if (end != text && *end == '\0' && seconds > 0 && seconds <= kMostSeconds) return seconds;
  std::fprintf(stderr, "spu_emu: SPU_EMU_PROCESS_TIME_LIMIT=\"%s\" is no number of seconds above 0\n", text);
  _exit(kOutOfTime);
}

/// Other threads may hold anything: nothing of the program is asked to end, and its output buffers are not
/// written.
[[noreturn]] void end_process(double seconds) {
  const std::string report = process_report();
  std::fprintf(stderr, "spu_emu: %g s are over, and the program has not ended:\n%s", seconds, report.c_str());
  _exit(kOutOfTime);
}

void watch(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  end_process(seconds);
}
}  // namespace

void start_process_time_limit() {
  [[maybe_unused]] static const bool started = [] {
    const char* limit = std::getenv("SPU_EMU_PROCESS_TIME_LIMIT");
    if (limit == nullptr || *limit == '\0') return false;
    std::thread(watch, seconds_in(limit)).detach();
    return true;
  }();
}

}  // namespace spu_emu
