/// @file
/// What the window shows: a scene or recording under an engine that can be exchanged while it runs.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"
#include "cellsweep/stream_view.h"
#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/scene.h"
#include "report/frame_clock.h"
#include "report/hand_over.h"
#include "view/live_scene.h"

namespace cellsweep::view {

struct SimulationSettings {
  std::optional<FrameFile> recording{};  ///< instead of a scene
  SceneSettings scene;
  std::string engine = "stream";
  SettingValues settings{};  ///< of all engines that may come: each gets those that it has
};

/// Steps of a world, each followed by the engine's update. A change that cannot be made says why and leaves
/// everything as it was. One thread at a time; nothing here knows of a window.
class Simulation {
 public:
  /// Stands at frame 0, its pairs found. Errors: those of the scene and of the engine.
  static Result<std::unique_ptr<Simulation>> make(SimulationSettings settings);

  /// One frame on; behind the last frame of a recording comes its first. Errors: those of the engine.
  Status step();

  /// Back to frame 0. Errors: those of the engine.
  Status restart();

  /// Goes on with another engine, from the boxes as they are. Errors: those of the engine.
  Status use_engine(std::string_view name);

  /// Another number of bodies: a new scene, at frame 0. Errors: bad_option with a recording or for no bodies,
  /// those of the scene and of the engine.
  Status use_bodies(std::size_t bodies);

  /// Another share of the bodies moves, 0 to 1; a scene that follows a script begins anew. Errors: bad_option
  /// with a recording, those of the scene.
  Status use_moving(double share);

  bool is_recording() const { return settings_.recording.has_value(); }
  std::string source_name() const { return source_->name(); }
  const FrameSource& source() const { return *source_; }
  const Aabb& bounds() const { return bounds_; }
  /// As many as there are ids; some may not be there now.
  std::size_t bodies() const { return source_->boxes().size(); }
  double moving() const { return moving_share(settings_.scene); }
  std::size_t frame() const { return frame_; }

  const std::string& engine_name() const { return settings_.engine; }
  const Broadphase& engine() const { return engine_; }

  /// What the engine took for the frame that is shown.
  const report::FrameTime& frame_time() const { return frame_time_; }

  /// What `stream` keeps around bodies and where it searches; nothing of other engines. As of now.
  std::optional<StreamView> stream_view() const { return cellsweep::stream_view(engine_); }

  /// By body: does its box overlap another's, as the engine says?
  const std::vector<bool>& colliding() const { return colliding_; }
  std::size_t began() const { return began_; }
  std::size_t ended() const { return ended_; }

  /// Milliseconds that the engine took for the latest frames, the newest last: hand-over and update, without
  /// set-up phases. Cleared by a change of engine or bodies.
  const std::vector<float>& frame_times() const { return frame_times_; }

  /// The local store of the engine's SPEs; nothing for an engine that has none.
  const std::optional<LocalStoreMap>& local_store() const { return local_store_; }

  /// How many frame_times() there are at most.
  static constexpr std::size_t kRememberedFrames = 240;

 private:
  explicit Simulation(SimulationSettings settings) : settings_(std::move(settings)) {}
  Status begin(const SimulationSettings& settings);
  Status start_engine(const SimulationSettings& settings, const FrameSource& source);
  void note_pairs(const PairChanges& changes);
  void remember_time(double milliseconds);
  Status begin_with(const SimulationSettings& settings);
  Status check_scene(std::string_view what) const;
  report::Shape shape() const;

  SimulationSettings settings_;
  std::unique_ptr<FrameSource> source_;
  LiveScene* live_ = nullptr;  // source_, when it is a scene that is a world
  Aabb bounds_;
  Broadphase engine_;
  report::FrameTime frame_time_;
  std::size_t frame_ = 0;
  std::vector<bool> colliding_;
  std::size_t began_ = 0;
  std::size_t ended_ = 0;
  std::vector<float> frame_times_;
  std::optional<LocalStoreMap> local_store_;
};

}  // namespace cellsweep::view
