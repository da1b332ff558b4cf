#include "report/frame_clock.h"

#include <chrono>

#include "base/threads/thread_clock.h"

namespace cellsweep::report {
namespace {

using Clock = std::chrono::steady_clock;

double sum_of(const std::vector<Phase>& phases, PhaseKind kind) {
  double sum = 0;
  for (const Phase& phase : phases) sum += phase.kind == kind ? phase.milliseconds : 0;
  return sum;
}

}  // namespace

Result<TimedFrame> time_frame(Broadphase& engine, const std::function<Status()>& hand_over) {
  const double cpu_start = thread_cpu_milliseconds();
  const Clock::time_point start = Clock::now();
  if (Status status = hand_over(); !status.ok()) return status;
  const auto changes = engine.update();
  const std::chrono::duration<double, std::milli> total = Clock::now() - start;
  const double cpu = thread_cpu_milliseconds() - cpu_start;
  if (!changes) return changes.status();
  TimedFrame frame{*changes, {total.count(), 0, 0, cpu, engine.statistics().phases}};
  frame.time.setup_ms = sum_of(frame.time.phases, PhaseKind::setup);
  frame.time.spes_ms = sum_of(frame.time.phases, PhaseKind::spes);
  return frame;
}

}  // namespace cellsweep::report
