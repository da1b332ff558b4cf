/// @file
/// What stands beside the world: settings to change, frame times, local stores, help.
#pragma once

#include "view/controller.h"

namespace cellsweep::view {

/// The panel's width in pixels.
constexpr int kPanelWidth = 330;

/// Colours, spacing and font of the current ImGui context.
void set_panel_style();

/// Between ImGui::NewFrame() and ImGui::Render(): the panel, with what the tool meets, and the help, as far
/// as the controller shows them.
class Panel {
 public:
  void draw(Controller& controller, const Met& met, float height);

 private:
  void draw_controls(Controller& controller);

  // What sliders show while they are held: a change takes effect when they are let go.
  int bodies_ = 0;
  float moving_percent_ = 0;
  bool held_ = false;
};

}  // namespace cellsweep::view
