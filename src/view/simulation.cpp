#include "view/simulation.h"

#include <chrono>

#include "base/text.h"
#include "report/picture/picture.h"
#include "report/run_engine.h"

namespace cellsweep::view {
namespace {

using Clock = std::chrono::steady_clock;

report::Shape shape_of(const EngineOptions& options) {
  return options.spu_boxes ? report::Shape::poses : report::Shape::boxes;
}

double setup_milliseconds(const Broadphase& engine) {
  double sum = 0;
  for (const Phase& phase : engine.statistics().phases) sum += phase.setup ? phase.milliseconds : 0;
  return sum;
}

Status refuse(std::string message, std::string setting) {
  return {StatusCode::bad_option, std::move(message), std::nullopt, 0, 0, std::move(setting)};
}

std::optional<LocalStoreMap> find_local_store(const SimulationSettings& settings, std::size_t bodies) {
  auto map = local_store_map(settings.engine, settings.options, bodies);
  return map ? std::optional(std::move(*map)) : std::nullopt;
}

}  // namespace

Result<std::unique_ptr<Simulation>> Simulation::make(SimulationSettings settings) {
  std::unique_ptr<Simulation> simulation(new Simulation(std::move(settings)));
  if (Status status = simulation->begin(simulation->settings_); !status.ok()) return status;
  return simulation;
}

// Changes nothing unless all goes well.
Status Simulation::begin(const SimulationSettings& settings) {
  std::unique_ptr<FrameSource> source;
  LiveScene* live = nullptr;
  Aabb bounds;
  if (settings.recording) {
    source = make_recording_frames(*settings.recording);
    bounds = report::stage_of(*settings.recording);
  } else {
    auto scene = LiveScene::make(settings.scene);
    if (!scene) return scene.status();
    live = scene->get();
    bounds = live->bounds();
    source = std::move(*scene);
  }
  if (Status status = start_engine(settings, *source); !status.ok()) return status;
  source_ = std::move(source);
  live_ = live;
  bounds_ = bounds;
  frame_ = 0;
  return {};
}

// A new engine with all boxes of the source, in the place of the old one if nothing goes wrong.
Status Simulation::start_engine(const SimulationSettings& settings, const FrameSource& source) {
  auto engine = make_engine(settings.engine, settings.options);
  if (!engine) return engine.status();
  if (Status status = report::insert_all(**engine, source, shape_of(settings.options)); !status.ok())
    return status;
  const auto changes = (*engine)->update();
  if (!changes) return changes.status();
  engine_ = std::move(*engine);
  settings_ = settings;
  local_store_ = find_local_store(settings, source.boxes().size());
  colliding_.assign(source.boxes().size(), false);
  note_pairs(*changes);
  return {};
}

Status Simulation::step() {
  if (!source_->advance()) return restart();
  const Clock::time_point start = Clock::now();
  const Status moved = report::move_changed(*engine_, *source_, shape_of(settings_.options));
  if (!moved.ok()) return moved;
  const auto changes = engine_->update();
  if (!changes) return changes.status();
  const std::chrono::duration<double, std::milli> time = Clock::now() - start;
  ++frame_;
  remember_time(time.count() - setup_milliseconds(*engine_));
  note_pairs(*changes);
  return {};
}

Status Simulation::restart() {
  return begin(settings_);
}

Status Simulation::use_engine(std::string_view name) {
  SimulationSettings wanted = settings_;
  wanted.engine = name;
  Status status = start_engine(wanted, *source_);
  if (status.ok()) frame_times_.clear();
  return status;
}

Status Simulation::use_bodies(std::size_t bodies) {
  if (Status status = check_scene("number of bodies"); !status.ok()) return status;
  if (bodies == 0) return refuse("A scene without bodies shows nothing.", "bodies");
  SimulationSettings wanted = settings_;
  wanted.scene.bodies = bodies;
  Status status = begin(wanted);
  if (status.ok()) frame_times_.clear();
  return status;
}

Status Simulation::use_moving(double share) {
  if (Status status = check_scene("share of moving bodies"); !status.ok()) return status;
  if (Status status = live_->set_moving(share); !status.ok()) return status;
  settings_.scene.moving = share;
  return {};
}

Status Simulation::check_scene(std::string_view what) const {
  if (live_ != nullptr) return {};
  return refuse(text("The ", what, " of a recording is what it is; only scenes change."), "recording");
}

void Simulation::note_pairs(const PairChanges& changes) {
  began_ = changes.began.size();
  ended_ = changes.ended.size();
  colliding_.assign(colliding_.size(), false);
  for (const Pair& pair : engine_->pairs()) {
    colliding_[pair.a] = true;
    colliding_[pair.b] = true;
  }
}

void Simulation::remember_time(double milliseconds) {
  if (frame_times_.size() == kRememberedFrames) frame_times_.erase(frame_times_.begin());
  frame_times_.push_back(static_cast<float>(milliseconds));
}

}  // namespace cellsweep::view
