#include "report/run_engine.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/text.h"
#include "report/all_engines.h"
#include "report/frame_clock.h"
#include "report/interrupt.h"
#include "report/progress.h"

namespace cellsweep::report {
namespace {

Status unreached_frame_status(std::size_t wanted, std::size_t last) {
  return Status::bad_input(text("Frame ", wanted, " was to be reported, but the last frame is ", last, "."),
                           "report_frames", wanted, last);
}

/// A run from its first frame to its last.
class Run {
 public:
  Run(Broadphase& engine, FrameSource& source, const RunSettings& settings)
      : engine_(engine),
        source_(source),
        settings_(settings),
        wanted_(settings.report_frames.begin(), settings.report_frames.end()) {
    report_.engine = engine.name();
    report_.bodies = source.bodies().size();
  }

  Result<RunReport> run() {
    if (Status status = first_frame(); !status.ok()) return status;
    if (Status status = later_frames(); !status.ok()) return status;
    if (wanted_.empty() && frame_ > 0) report_pairs();
    if (!wanted_.empty() && *wanted_.rbegin() > frame_ && !is_interrupted())
      return unreached_frame_status(*wanted_.rbegin(), frame_);
    return std::move(report_);
  }

 private:
  Status first_frame() {
    if (Status status = source_.status(); !status.ok()) return status;
    const auto time = timed([&] { return insert_all(engine_, source_, settings_.shape); });
    if (!time) return time.status();
    report_.initial_ms = *time;
    return {};
  }

  Status later_frames() {
    Progress progress(report_.engine, settings_.updates);
    while (frame_ < settings_.updates && !is_interrupted() && source_.advance()) {
      ++frame_;
      const auto time = timed([&] { return hand_over_changes(engine_, source_, settings_.shape); });
      if (!time) return time.status();
      report_.update_ms.push_back(*time);
      progress.show(frame_);
    }
    return source_.status();
  }

  /// Milliseconds of one frame's work, once it is reported.
  Result<double> timed(const std::function<Status()>& hand_over) {
    const auto frame = time_frame(engine_, hand_over);
    if (!frame) return frame.status();
    report_.setup_ms += frame->time.setup_ms;
    report_cell(frame->time);
    if (wanted_.empty() ? frame_ == 0 : wanted_.contains(frame_)) report_pairs();
    return frame->time.work_ms();
  }

  void report_cell(const FrameTime& time) {
    const auto statistics = statistics_of_spes(engine_);
    if (!statistics || !statistics->time) return;
    report_.cell.push_back({frame_, handed_over(), statistics->time->spes,
                            std::max(0.0, time.cpu_ms - statistics->time->set_aside_ms),
                            statistics->time->threads_started});
  }

  std::size_t handed_over() const {
    if (frame_ == 0) return report_.bodies;
    return source_.moved().size() + source_.inserted().size() + source_.removed().size();
  }

  void report_pairs() {
    report_.frames.push_back({frame_, engine_.pairs().size(), pair_set_hash(engine_.pairs())});
  }

  Broadphase& engine_;
  FrameSource& source_;
  const RunSettings& settings_;
  std::set<std::size_t> wanted_;
  std::size_t frame_ = 0;
  RunReport report_;
};

}  // namespace

double CellFrame::longest_us() const {
  double longest = 0;
  for (const SpeTime& spe : spes) longest = std::max(longest, spe.total());
  return longest;
}

Result<RunReport> run_engine(Broadphase& engine, FrameSource& source, const RunSettings& settings) {
  return Run(engine, source, settings).run();
}

}  // namespace cellsweep::report
