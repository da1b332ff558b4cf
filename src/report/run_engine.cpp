#include "report/run_engine.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>

#include "base/text.h"
#include "base/thread_clock.h"
#include "report/progress.h"

namespace cellsweep::report {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double setup_milliseconds(const Broadphase& engine) {
  double sum = 0;
  for (const Phase& phase : engine.statistics().phases) sum += phase.setup ? phase.milliseconds : 0;
  return sum;
}

/// One frame's work: on the clock, without set-up; and the CPU time of the calling thread, with it.
struct FrameTime {
  double frame_ms = 0;
  double cpu_ms = 0;
};

template <class HandOver>
Status timed_frame(Broadphase& engine, RunReport& report, FrameTime& time, HandOver&& hand_over) {
  const double cpu_start = thread_cpu_milliseconds();
  const Clock::time_point start = Clock::now();
  if (Status status = hand_over(); !status.ok()) return status;
  if (const auto changes = engine.update(); !changes) return changes.status();
  const double total = milliseconds_since(start);
  time.cpu_ms = thread_cpu_milliseconds() - cpu_start;
  const double setup = setup_milliseconds(engine);
  report.setup_ms += setup;
  time.frame_ms = total - setup;
  return {};
}

void report_cell(const Broadphase& engine, std::size_t frame, std::size_t moved, double cpu_ms,
                 RunReport& report) {
  const std::optional<CellTime>& cell = engine.statistics().cell;
  if (!cell) return;
  report.cell.push_back(
      {frame, moved, cell->spes, std::max(0.0, cpu_ms - cell->set_aside_ms), cell->threads_started});
}

void report_frame(const Broadphase& engine, std::size_t frame, RunReport& report) {
  report.frames.push_back({frame, engine.pairs().size(), pair_set_hash(engine.pairs())});
}

Status unreached_frame_status(std::size_t wanted, std::size_t last) {
  return {StatusCode::bad_input,
          text("Frame ", wanted, " was to be reported, but the last frame is ", last, "."),
          std::nullopt,
          wanted,
          last,
          "report-frames"};
}

Status no_poses_status(const std::string& source) {
  return {StatusCode::bad_input,
          text("Source ", source, " has boxes only; no engine can make them from poses."),
          std::nullopt,
          0,
          0,
          "spu-boxes"};
}

template <class T>
std::vector<T> of_moved(const FrameSource& source, std::span<const T> all) {
  std::vector<T> some;
  some.reserve(source.moved().size());
  for (const BodyId id : source.moved()) some.push_back(all[id]);
  return some;
}

}  // namespace

double CellFrame::longest_us() const {
  double longest = 0;
  for (const SpeTime& spe : spes) longest = std::max(longest, spe.total());
  return longest;
}

Status insert_all(Broadphase& engine, const FrameSource& source, Shape shape) {
  std::vector<BodyId> ids(source.boxes().size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  if (shape == Shape::boxes) return engine.insert(ids, source.boxes());
  if (source.poses().size() != ids.size()) return no_poses_status(source.name());
  return engine.insert_poses(ids, source.poses());
}

Status move_changed(Broadphase& engine, const FrameSource& source, Shape shape) {
  if (shape == Shape::boxes) return engine.move(source.moved(), of_moved(source, source.boxes()));
  return engine.move_poses(source.moved(), of_moved(source, source.poses()));
}

Result<RunReport> run_engine(Broadphase& engine, FrameSource& source, const RunSettings& settings) {
  RunReport report;
  report.engine = engine.name();
  report.bodies = source.boxes().size();
  const std::set<std::size_t> wanted(settings.report_frames.begin(), settings.report_frames.end());
  const auto is_wanted = [&](std::size_t frame) {
    return wanted.empty() ? frame == 0 : wanted.contains(frame);
  };

  FrameTime time;
  Status status =
      timed_frame(engine, report, time, [&] { return insert_all(engine, source, settings.shape); });
  if (!status.ok()) return status;
  report.initial_ms = time.frame_ms;
  report_cell(engine, 0, report.bodies, time.cpu_ms, report);
  if (is_wanted(0)) report_frame(engine, 0, report);

  Progress progress(report.engine, settings.updates);
  std::size_t frame = 0;
  while (frame < settings.updates && source.advance()) {
    ++frame;
    status = timed_frame(engine, report, time, [&] { return move_changed(engine, source, settings.shape); });
    if (!status.ok()) return status;
    report.update_ms.push_back(time.frame_ms);
    report_cell(engine, frame, source.moved().size(), time.cpu_ms, report);
    if (is_wanted(frame)) report_frame(engine, frame, report);
    progress.show(frame);
  }
  if (wanted.empty() && frame > 0) report_frame(engine, frame, report);
  if (!wanted.empty() && *wanted.rbegin() > frame) return unreached_frame_status(*wanted.rbegin(), frame);
  return report;
}

}  // namespace cellsweep::report
