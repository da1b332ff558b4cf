/// @file
/// What keys and sliders do: pause, step, change the simulation, and say what could not be changed.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "view/drawn_boxes.h"
#include "view/orbit_camera.h"
#include "view/probe.h"
#include "view/simulation.h"

namespace cellsweep::view {

/// What a key does.
enum class Action {
  pause,
  step,
  restart,
  next_engine,
  previous_engine,
  more_bodies,
  fewer_bodies,
  more_moving,
  fewer_moving,
  turn_left,
  turn_right,
  turn_up,
  turn_down,
  zoom_in,
  zoom_out,
  first_view,
  show_fat_boxes,
  show_cells,
  next_tool,
  larger_box,
  smaller_box,
  show_reason,
  show_panel,
  show_help,
  quit,
};

/// Keys without a character of their own; the others go by it, letters as capitals.
enum SpecialKey : int { kEscape = 0x100, kLeft, kRight, kUp, kDown };

struct KeyBinding {
  int key;
  std::string_view name;  ///< what stands on the key
  Action action;
  std::string_view text;  ///< what it does, for the help
  bool repeats = false;   ///< does it again and again while it is held
};

/// All keys, in the order of the help.
std::span<const KeyBinding> key_bindings();

/// The state of the window that is not the simulation's. One thread at a time.
class Controller {
 public:
  /// The simulation outlives the controller.
  explicit Controller(Simulation& simulation)
      : simulation_(simulation), camera_(simulation.bounds()), probe_(simulation.bounds()) {}

  /// Once a picture: goes one frame on, unless paused.
  void tick();

  /// Does what the key is for; a key that is for nothing does nothing. `held`: it was pressed before and not
  /// let go.
  void press(int key, bool held = false);
  void act(Action action);

  void use_engine(std::string_view name);
  void use_bodies(std::size_t bodies);
  void use_moving(double share);

  /// The mouse takes the tool at a point of the world's picture, in pixels from its upper left corner, and
  /// has moved to another.
  void grab(const Eigen::Vector2f& pixel, float width, float height);
  void drag(const Eigen::Vector2f& pixel, float width, float height);

  const Simulation& simulation() const { return simulation_; }
  OrbitCamera& camera() { return camera_; }
  const OrbitCamera& camera() const { return camera_; }
  Probe& probe() { return probe_; }
  const Probe& probe() const { return probe_; }
  bool paused() const { return paused_; }
  bool shows_panel() const { return shows_panel_; }
  bool shows_help() const { return shows_help_; }
  bool wants_to_quit() const { return wants_to_quit_; }

  /// Why the last change was not made; empty after one that was.
  const std::string& complaint() const { return complaint_; }
  /// Whether all of the complaint is wanted, or one line that says there is one.
  bool shows_reason() const { return shows_reason_; }

  /// What of `stream` is to be seen, whichever engine runs.
  const StreamParts& stream_parts() const { return stream_parts_; }

 private:
  void step();
  void look_at_another_world();
  void show_of_stream(bool StreamParts::*part);
  void note(const Status& status);
  void change_engine(int by);
  void change_moving(double by);

  Simulation& simulation_;
  OrbitCamera camera_;
  Probe probe_;
  bool paused_ = false;
  bool shows_panel_ = true;
  bool shows_help_ = false;
  bool wants_to_quit_ = false;
  bool shows_reason_ = false;
  StreamParts stream_parts_;
  std::string tried_engine_;  // by key; it may have been refused
  std::string complaint_;
};

}  // namespace cellsweep::view
