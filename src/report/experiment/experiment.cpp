#include "report/experiment/experiment.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/text.h"
#include "cellsweep/engines.h"
#include "report/build_context.h"
#include "report/experiment/experiment_run.h"
#include "report/interrupt.h"
#include "report/progress.h"
#include "report/quantile.h"
#include "report/units.h"

namespace cellsweep::report {
namespace {

constexpr std::size_t kMostBodies = std::size_t{1} << 24;

Status check(const ExperimentSettings& settings) {
  if (settings.bodies.empty())
    return Status::bad_option("bodies", "There is no number of boxes to run the experiment with.");
  for (const std::size_t bodies : settings.bodies) {
    if (bodies == 0 || bodies > kMostBodies) {
      return Status::bad_option(
          "bodies", text("The experiment runs with 1 to ", kMostBodies, " boxes, not ", bodies, "."), bodies,
          kMostBodies);
    }
  }
  if (settings.frames == 0) return Status::bad_option("frames", "The experiment needs 1 frame or more.");
  if (settings.repetitions == 0)
    return Status::bad_option("repetitions", "The experiment needs 1 repetition or more.");
  return {};
}

Spread spread_of(const std::vector<double>& values) {
  return {quantile(values, 0.5), quantile(values, 0), quantile(values, 1), values.size()};
}

class Experiment {
 public:
  explicit Experiment(const ExperimentSettings& settings) {
    results_.settings = settings;
    results_.context = build_context();
    auto& sizes = results_.settings.bodies;
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    find_engines();
  }

  Result<ExperimentResults> run() {
    Progress progress("experiment, frame", frames_in_all());
    frame_done_ = [&] { progress.show(++frames_done_); };
    for (unsigned repetition = 0; repetition < results_.settings.repetitions; ++repetition) {
      if (Status status = run_all_once(repetition); !status.ok()) return status;
    }
    if (is_interrupted()) note_interruption();
    add_curves();
    return std::move(results_);
  }

 private:
  struct Place {
    std::string engine;
    bool simulated;
    std::size_t bodies;
    std::vector<ExperimentRun> runs;
  };

  static bool has_curve(std::string_view engine, bool simulated) {
    const auto curves = curve_table();
    return std::any_of(curves.begin(), curves.end(), [&](const Curve& curve) {
      return curve.engine == engine && is_simulated(curve) == simulated;
    });
  }

  static bool is_simulated(const Curve& curve) { return curve.part == Part::simulated_cell; }

  void find_engines() {
    for (const EngineInfo& info : engine_table()) {
      const std::string name(info.name);
      if (has_curve(name, false)) find_places(name);
      if (has_curve(name, true) && results_.settings.simulated_frames > 0) find_simulated_places(name);
    }
  }

  void find_places(const std::string& name) {
    const auto engine = make_broadphase(name);
    if (!engine) {
      leave_out(text("Engine ", name, " is left out: ", engine.status().message));
      return;
    }
    const Capacity capacity = engine->capacity();
    for (const std::size_t bodies : results_.settings.bodies) {
      if (bodies <= capacity.bodies) {
        places_.push_back({name, false, bodies, {}});
      } else {
        leave_out(text("Engine ", name, " holds ", capacity.bodies, " boxes, not ", bodies, ": ",
                       capacity.reason, "."));
      }
    }
  }

  void find_simulated_places(const std::string& name) {
    const auto engine = make_broadphase(name, settings_of_engine(true));
    if (!engine) {
      leave_out(text("The simulated Cell is left out for ", name, ": ", engine.status().message));
      return;
    }
    const std::size_t most = results_.settings.simulated_most_bodies;
    for (const std::size_t bodies : results_.settings.bodies) {
      if (bodies <= std::min<std::uint64_t>(most, engine->capacity().bodies)) {
        places_.push_back({name, true, bodies, {}});
      } else {
        leave_out(text("Engine ", name, " on the simulated Cell is left out with ", count_text(bodies),
                       " boxes: more than ", count_text(most), " take too long for this run."));
      }
    }
  }

  void leave_out(std::string sentence) { results_.left_out.push_back(std::move(sentence)); }

  void note_interruption() {
    std::size_t made = 0;
    std::size_t wanted = 0;
    for (const Place& place : places_) {
      made += place.runs.size();
      wanted += place.simulated ? 1 : results_.settings.repetitions;
    }
    results_.interrupted = text("Stopped by ", interrupt_name(), " when ", made, " of ", wanted,
                                " runs were done; there is nothing here of the others.");
  }

  std::size_t frames_in_all() const {
    std::size_t frames = 0;
    for (const Place& place : places_) {
      frames += 2 * frames_of_kind(place.simulated, results_.settings) *
                (place.simulated ? 1 : results_.settings.repetitions);
    }
    return frames;
  }

  // All engines at a size before the next size; who is first changes.
  Status run_all_once(unsigned repetition) {
    for (const std::size_t bodies : results_.settings.bodies) {
      std::vector<Place*> turn;
      for (Place& place : places_) {
        if (place.bodies == bodies && !(place.simulated && repetition > 0)) turn.push_back(&place);
      }
      if (turn.empty()) continue;
      std::rotate(turn.begin(), turn.begin() + static_cast<std::ptrdiff_t>(repetition % turn.size()),
                  turn.end());
      for (Place* place : turn) {
        if (is_interrupted()) return {};
        if (Status status = run_once(*place); !status.ok()) return status;
      }
    }
    return {};
  }

  Status run_once(Place& place) {
    auto run =
        run_through_experiment(place.engine, place.simulated, place.bodies, results_.settings, frame_done_);
    if (!run) return run.status();
    if (!run->complete) return {};
    if (!run->exact) {
      results_.wrong.push_back(text("Engine ", place.engine, " with ", place.bodies,
                                    " boxes ended with other pairs than the oracle's."));
    }
    if (!place.simulated) {
      results_.initial_steps[{place.engine, place.bodies}] = run->initial_steps;
      results_.moving_steps[{place.engine, place.bodies}] = run->moving_steps;
      results_.pairs[place.bodies] = run->pairs;
    }
    place.runs.push_back(std::move(*run));
    return {};
  }

  void add_curves() {
    for (const Curve& curve : curve_table()) {
      CurveResult result{curve, {}};
      for (const Place& place : places_) {
        if (place.engine == curve.engine && place.simulated == is_simulated(curve) && !place.runs.empty())
          result.points[place.bodies] = spreads_of(place.runs, curve.part);
      }
      if (!result.points.empty()) results_.curves.push_back(std::move(result));
    }
  }

  static PerMeasure<Spread> spreads_of(const std::vector<ExperimentRun>& runs, Part part) {
    PerMeasure<Spread> spreads;
    for (const Measure measure : kAllMeasures) {
      std::vector<double> values;
      values.reserve(runs.size());
      for (const ExperimentRun& run : runs)
        values.push_back(run.times[static_cast<std::size_t>(part)][measure]);
      spreads[measure] = spread_of(values);
    }
    return spreads;
  }

  ExperimentResults results_;
  std::vector<Place> places_;
  std::size_t frames_done_ = 0;
  std::function<void()> frame_done_;
};

}  // namespace

std::optional<double> ExperimentResults::at(std::string_view curve, std::size_t bodies,
                                            Measure measure) const {
  for (const CurveResult& result : curves) {
    const auto point = result.points.find(bodies);
    if (result.curve.id == curve && point != result.points.end()) return point->second[measure].median;
  }
  return std::nullopt;
}

Result<ExperimentResults> run_experiment(const ExperimentSettings& settings) {
  if (Status status = check(settings); !status.ok()) return status;
  return Experiment(settings).run();
}

}  // namespace cellsweep::report
