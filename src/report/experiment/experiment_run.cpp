#include "report/experiment/experiment_run.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "cellsweep/world/scene.h"
#include "report/all_engines.h"
#include "report/frame_clock.h"
#include "report/hand_over.h"
#include "report/interrupt.h"
#include "report/oracle.h"
#include "report/quantile.h"

namespace cellsweep::report {
namespace {

// One first frame is short, and may meet anything; but those of some engines take long.
constexpr std::size_t kMostFirstFrames = 9;
constexpr double kEnoughOfFirstFrames = 1e5;  // microseconds

/// The times of many frames: by part, and by step of the engine.
class FrameTimes {
 public:
  /// Hands over and updates, and adds what that took.
  Status add(Broadphase& engine, const std::function<Status()>& hand_over) {
    const auto frame = time_frame(engine, hand_over);
    if (!frame) return frame.status();
    for (const Phase& phase : frame->time.phases) {
      if (phase.kind != PhaseKind::setup) times_of_step(phase.name).push_back(1000 * phase.milliseconds);
    }
    add_part(Part::frame, 1000 * frame->time.work_ms());
    add_part(Part::spus, 1000 * frame->time.spes_ms);
    const CellStatistics spes = statistics_of_spes(engine).value_or(CellStatistics{});
    add_part(Part::longest_spu, 1000 * spes.longest_spu_ms);
    add_part(Part::simulated_cell, longest_spe(spes));
    return {};
  }

  double total() const {
    double sum = 0;
    for (const double frame : parts_[0]) sum += frame;
    return sum;
  }

  /// Order statistic `q` of a part.
  double at(std::size_t part, double q) const { return quantile(parts_[part], q); }

  /// The median of each step, in the order they run.
  std::vector<Step> steps() const {
    std::vector<Step> result;
    for (const auto& [name, times] : steps_) result.push_back({name, quantile(times, 0.5)});
    return result;
  }

 private:
  static double longest_spe(const CellStatistics& statistics) {
    double longest = 0;
    if (!statistics.time) return longest;
    for (const SpeTime& spe : statistics.time->spes) longest = std::max(longest, spe.total());
    return longest;
  }

  void add_part(Part part, double microseconds) {
    parts_[static_cast<std::size_t>(part)].push_back(microseconds);
  }

  std::vector<double>& times_of_step(std::string_view name) {
    const auto found =
        std::find_if(steps_.begin(), steps_.end(), [&](const auto& step) { return step.first == name; });
    if (found != steps_.end()) return found->second;
    return steps_.emplace_back(std::string(name), std::vector<double>{}).second;
  }

  std::array<std::vector<double>, kParts> parts_;
  std::vector<std::pair<std::string, std::vector<double>>> steps_;
};

bool has_pairs_of_oracle(const Broadphase& engine, const FrameSource& source) {
  const std::vector<Pair> truth = oracle_pairs(source);
  return std::equal(engine.pairs().begin(), engine.pairs().end(), truth.begin(), truth.end());
}

class Passage {
 public:
  Passage(bool simulated, const ExperimentSettings& settings, const std::function<void()>& frame_done)
      : simulated_(simulated),
        frames_(frames_of_kind(simulated, settings)),
        settings_(settings),
        frame_done_(frame_done) {}

  Result<ExperimentRun> run(const std::string& name, std::size_t bodies) {
    auto source = make_scene_frames({.bodies = bodies, .seed = settings_.seed, .moving = settings_.moving});
    if (!source) return source.status();
    if (Status status = enter(name, **source); !status.ok()) return status;
    if (Status status = run_frames(**source); !status.ok()) return status;
    ExperimentRun run;
    if (is_interrupted()) return run;
    for (std::size_t part = 0; part < kParts; ++part) {
      run.times[part][Measure::initial] = initial_.at(part, 0.5);
      run.times[part][Measure::still] = still_.at(part, 0.5);
      run.times[part][Measure::longest] = moving_.at(part, 1);
      run.times[part][Measure::median] = moving_.at(part, 0.5);
    }
    run.initial_steps = initial_.steps();
    run.moving_steps = moving_.steps();
    run.pairs = engine_->pairs().size();
    run.exact = has_pairs_of_oracle(*engine_, **source);
    run.complete = true;
    return run;
  }

 private:
  Status enter(const std::string& name, const FrameSource& source) {
    const std::size_t first_frames = simulated_ ? 1 : kMostFirstFrames;
    for (std::size_t i = 0; i < first_frames && initial_.total() < kEnoughOfFirstFrames; ++i) {
      if (i > 0 && is_interrupted()) return {};
      engine_.reset();
      auto made = make_broadphase(name, settings_of_engine(simulated_));
      if (!made) return made.status();
      engine_ = std::move(*made);
      const auto hand_over = [&] { return insert_all(*engine_, source); };
      if (Status status = initial_.add(*engine_, hand_over); !status.ok()) return status;
    }
    return {};
  }

  Status run_frames(FrameSource& source) {
    for (std::size_t i = 0; i < frames_ && !is_interrupted(); ++i) {
      if (Status status = still_.add(*engine_, hand_over_nothing); !status.ok()) return status;
      frame_done_();
    }
    for (std::size_t i = 0; i < frames_ && !is_interrupted(); ++i) {
      source.advance();
      const auto hand_over = [&] { return hand_over_changes(*engine_, source); };
      if (Status status = moving_.add(*engine_, hand_over); !status.ok()) return status;
      frame_done_();
    }
    return {};
  }

  bool simulated_;
  std::size_t frames_;
  const ExperimentSettings& settings_;
  const std::function<void()>& frame_done_;
  std::optional<Broadphase> engine_;
  FrameTimes initial_;
  FrameTimes still_;
  FrameTimes moving_;
};

}  // namespace

SettingValues settings_of_engine(bool simulated) {
  if (!simulated) return {};
  return {{"spe_engine", "isa"}, {"cycles", "true"}};
}

std::size_t frames_of_kind(bool simulated, const ExperimentSettings& settings) {
  return simulated ? std::min(settings.frames, settings.simulated_frames) : settings.frames;
}

Result<ExperimentRun> run_through_experiment(const std::string& engine, bool simulated, std::size_t bodies,
                                             const ExperimentSettings& settings,
                                             const std::function<void()>& frame_done) {
  return Passage(simulated, settings, frame_done).run(engine, bodies);
}

}  // namespace cellsweep::report
