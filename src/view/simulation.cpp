#include "view/simulation.h"

#include "base/text.h"
#include "report/all_engines.h"
#include "report/engine_settings.h"
#include "report/picture/picture.h"

namespace cellsweep::view {
namespace {

std::optional<LocalStoreMap> find_local_store(const SimulationSettings& settings, std::size_t bodies) {
  auto map =
      report::local_store_of(settings.engine, report::values_for(settings.engine, settings.settings), bodies);
  return map ? std::optional(std::move(*map)) : std::nullopt;
}

bool follows_a_script(const SceneSettings& settings) {
  const SceneInfo* scene = find_scene(settings.scene);
  return scene != nullptr && !scene->is_world;
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
    source = settings.recording->make_source();
    bounds = report::stage_of(*settings.recording);
  } else if (follows_a_script(settings.scene)) {
    auto frames = make_scene_frames(settings.scene);
    if (!frames) return frames.status();
    bounds = *scene_bounds(settings.scene);
    source = std::move(*frames);
  } else {
    auto scene = LiveScene::make(settings.scene);
    if (!scene) return scene.status();
    live = scene->get();
    bounds = live->bounds();
    source = std::move(*scene);
  }
  if (Status status = source->status(); !status.ok()) return status;
  if (Status status = start_engine(settings, *source); !status.ok()) return status;
  source_ = std::move(source);
  live_ = live;
  bounds_ = bounds;
  frame_ = 0;
  return {};
}

// A new engine with all boxes of the source, in the place of the old one if nothing goes wrong.
Status Simulation::start_engine(const SimulationSettings& settings, const FrameSource& source) {
  const SettingValues values = report::values_for(settings.engine, settings.settings);
  auto engine = make_broadphase(settings.engine, values);
  if (!engine) return engine.status();
  const auto frame = report::time_frame(
      *engine, [&] { return report::insert_all(*engine, source, report::shape_of(values)); });
  if (!frame) return frame.status();
  engine_ = std::move(*engine);
  settings_ = settings;
  frame_time_ = frame->time;
  local_store_ = find_local_store(settings, source.boxes().size());
  colliding_.assign(source.boxes().size(), false);
  note_pairs(frame->changes);
  return {};
}

Status Simulation::step() {
  if (!source_->advance()) return source_->status().ok() ? restart() : source_->status();
  const auto frame =
      report::time_frame(engine_, [&] { return report::hand_over_changes(engine_, *source_, shape()); });
  if (!frame) return frame.status();
  ++frame_;
  frame_time_ = frame->time;
  remember_time(frame->time.work_ms());
  note_pairs(frame->changes);
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
  if (bodies == 0) return Status::bad_option("bodies", "A scene without bodies shows nothing.");
  SimulationSettings wanted = settings_;
  wanted.scene.bodies = bodies;
  return begin_with(wanted);
}

Status Simulation::use_moving(double share) {
  if (Status status = check_scene("share of moving bodies"); !status.ok()) return status;
  if (live_ == nullptr) {
    SimulationSettings wanted = settings_;
    wanted.scene.moving = share;
    return begin_with(wanted);
  }
  if (Status status = live_->set_moving(share); !status.ok()) return status;
  settings_.scene.moving = share;
  if (live_->filters().empty()) return {};
  return engine_.set_filters(live_->bodies(), live_->filters());
}

Status Simulation::begin_with(const SimulationSettings& settings) {
  Status status = begin(settings);
  if (status.ok()) frame_times_.clear();
  return status;
}

Status Simulation::check_scene(std::string_view what) const {
  if (!is_recording()) return {};
  return Status::bad_option("recording",
                            text("The ", what, " of a recording is what it is; only scenes change."));
}

report::Shape Simulation::shape() const {
  return report::shape_of(report::values_for(settings_.engine, settings_.settings));
}

void Simulation::note_pairs(const PairChanges& changes) {
  began_ = changes.began.size();
  ended_ = changes.ended.size();
  colliding_.assign(colliding_.size(), false);
  for (const Pair& pair : engine_.pairs()) {
    colliding_[pair.a] = true;
    colliding_[pair.b] = true;
  }
}

void Simulation::remember_time(double milliseconds) {
  if (frame_times_.size() == kRememberedFrames) frame_times_.erase(frame_times_.begin());
  frame_times_.push_back(static_cast<float>(milliseconds));
}

}  // namespace cellsweep::view
