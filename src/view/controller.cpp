#include "view/controller.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"

namespace cellsweep::view {
namespace {

constexpr float kTurn = 0.08F;  // radians
constexpr float kZoom = 1.1F;
constexpr float kGrowth = 1.2F;
constexpr double kMovingStep = 0.1;

constexpr std::array kBindings = {
    KeyBinding{' ', "Space", Action::pause, "pause, go on"},
    KeyBinding{'N', "N", Action::step, "pause and go one frame on", true},
    KeyBinding{'R', "R", Action::restart, "back to the first frame"},
    KeyBinding{'E', "E", Action::next_engine, "next engine"},
    KeyBinding{'Q', "Q", Action::previous_engine, "engine before"},
    KeyBinding{'B', "B", Action::more_bodies, "twice the bodies"},
    KeyBinding{'V', "V", Action::fewer_bodies, "half the bodies"},
    KeyBinding{'M', "M", Action::more_moving, "10 % more of them move"},
    KeyBinding{'L', "L", Action::fewer_moving, "10 % fewer move"},
    KeyBinding{kLeft, "Left", Action::turn_left, "turn left", true},
    KeyBinding{kRight, "Right", Action::turn_right, "turn right", true},
    KeyBinding{kUp, "Up", Action::turn_up, "look from higher up", true},
    KeyBinding{kDown, "Down", Action::turn_down, "look from lower down", true},
    KeyBinding{'+', "+", Action::zoom_in, "nearer", true},
    KeyBinding{'-', "-", Action::zoom_out, "farther away", true},
    KeyBinding{'0', "0", Action::first_view, "the view of the beginning"},
    KeyBinding{'F', "F", Action::show_fat_boxes, "fat boxes of stream on, off"},
    KeyBinding{'C', "C", Action::show_cells, "cells of stream on, off"},
    KeyBinding{'T', "T", Action::next_tool, "a box to hold into the world, a ray, none"},
    KeyBinding{'G', "G", Action::larger_box, "a larger box", true},
    KeyBinding{'S', "S", Action::smaller_box, "a smaller box", true},
    KeyBinding{'W', "W", Action::show_reason, "why something was refused, in full"},
    KeyBinding{'P', "P", Action::show_panel, "panel on, off"},
    KeyBinding{'H', "H", Action::show_help, "this help on, off"},
    KeyBinding{kEscape, "Esc", Action::quit, "end"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() {
  return kBindings;
}

void Controller::tick() {
  if (!paused_) step();
}

void Controller::press(int key, bool held) {
  const auto binding =
      std::find_if(kBindings.begin(), kBindings.end(), [&](const KeyBinding& b) { return b.key == key; });
  if (binding != kBindings.end() && (!held || binding->repeats)) act(binding->action);
}

void Controller::act(Action action) {
  switch (action) {
    case Action::pause:
      paused_ = !paused_;
      return;
    case Action::step:
      paused_ = true;
      return step();
    case Action::restart:
      return note(simulation_.restart());
    case Action::next_engine:
      return change_engine(1);
    case Action::previous_engine:
      return change_engine(-1);
    case Action::more_bodies:
      return use_bodies(2 * simulation_.bodies());
    case Action::fewer_bodies:
      return use_bodies(std::max<std::size_t>(1, simulation_.bodies() / 2));
    case Action::more_moving:
      return change_moving(kMovingStep);
    case Action::fewer_moving:
      return change_moving(-kMovingStep);
    case Action::turn_left:
      return camera_.orbit(-kTurn, 0);
    case Action::turn_right:
      return camera_.orbit(kTurn, 0);
    case Action::turn_up:
      return camera_.orbit(0, kTurn);
    case Action::turn_down:
      return camera_.orbit(0, -kTurn);
    case Action::zoom_in:
      return camera_.zoom(1 / kZoom);
    case Action::zoom_out:
      return camera_.zoom(kZoom);
    case Action::first_view:
      camera_ = OrbitCamera(simulation_.bounds());
      return;
    case Action::show_fat_boxes:
      return show_of_stream(&StreamParts::fat_boxes);
    case Action::show_cells:
      return show_of_stream(&StreamParts::cells);
    case Action::next_tool:
      return probe_.choose_next();
    case Action::larger_box:
      return probe_.resize(kGrowth);
    case Action::smaller_box:
      return probe_.resize(1 / kGrowth);
    case Action::show_reason:
      shows_reason_ = !shows_reason_;
      return;
    case Action::show_panel:
      shows_panel_ = !shows_panel_;
      return;
    case Action::show_help:
      shows_help_ = !shows_help_;
      return;
    case Action::quit:
      wants_to_quit_ = true;
      return;
  }
}

void Controller::use_engine(std::string_view name) {
  tried_engine_ = name;
  note(simulation_.use_engine(name));
}

void Controller::grab(const Eigen::Vector2f& pixel, float width, float height) {
  probe_.grab(camera_.look_through(pixel, width, height), simulation_.engine());
}

void Controller::drag(const Eigen::Vector2f& pixel, float width, float height) {
  probe_.drag(camera_.look_through(pixel, width, height));
}

void Controller::use_bodies(std::size_t bodies) {
  const Aabb before = simulation_.bounds();
  note(simulation_.use_bodies(bodies));
  if (!(simulation_.bounds() == before)) look_at_another_world();
}

// The tool stays, and lies in the new world as it did at first in the old one.
void Controller::look_at_another_world() {
  camera_ = OrbitCamera(simulation_.bounds());
  const Tool tool = probe_.tool();
  probe_ = Probe(simulation_.bounds());
  probe_.choose(tool);
}

void Controller::use_moving(double share) {
  note(simulation_.use_moving(share));
}

// What fails once fails again: the picture stands still instead of complaining every frame.
void Controller::step() {
  const Status status = simulation_.step();
  if (status.ok()) return;
  note(status);
  paused_ = true;
}

// Where another engine runs they are not there to be seen, which is said; they show when stream runs again.
void Controller::show_of_stream(bool StreamParts::*part) {
  stream_parts_.*part = !(stream_parts_.*part);
  const bool is_seen = !(stream_parts_.*part) || simulation_.stream_view();
  note(is_seen ? Status{}
               : Status::bad_option("engine", text("Engine ", simulation_.engine_name(),
                                                   " has no fat boxes and cells; stream has.")));
}

void Controller::note(const Status& status) {
  complaint_ = status.message;
  shows_reason_ = false;
}

// From the one that was tried last, so that one which cannot be had is passed by the next press.
void Controller::change_engine(int by) {
  const auto table = engine_table();
  const std::string_view from = tried_engine_.empty() ? simulation_.engine_name() : tried_engine_;
  const auto now =
      std::find_if(table.begin(), table.end(), [&](const EngineInfo& info) { return info.name == from; });
  const auto count = static_cast<std::ptrdiff_t>(table.size());
  const std::ptrdiff_t next = (now - table.begin() + by + count) % count;
  use_engine(table[static_cast<std::size_t>(next)].name);
}

// To whole tenths, so that up and down meets the same shares.
void Controller::change_moving(double by) {
  const double wanted = std::round((simulation_.moving() + by) * 10) / 10;
  use_moving(std::clamp(wanted, 0.0, 1.0));
}

}  // namespace cellsweep::view
