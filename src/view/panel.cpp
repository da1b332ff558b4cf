#include "view/panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "report/units.h"
#include "view/panel_charts.h"

namespace cellsweep::view {
namespace {

constexpr int kFewestBodies = 16;
constexpr int kMostBodies = 65536;
constexpr float kFontSize = 14.5F;
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
const ImVec4 kWarning = {0.78F, 0.16F, 0.10F, 1};
const ImVec4 kFaint = {0.42F, 0.46F, 0.52F, 1};
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoNav;

void heading(const char* text) {
  ImGui::Dummy({0, 4});
  ImGui::TextColored(kFaint, "%s", text);
}

void row(const char* name, const std::string& value) {
  ImGui::TextUnformatted(name);
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x +
                  ImGui::GetCursorPosX());
  ImGui::TextUnformatted(value.c_str());
}

std::string percent_text(float percent) {
  return std::to_string(std::lround(percent)) + " %";
}

void draw_engine_choice(Controller& controller) {
  const Simulation& simulation = controller.simulation();
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##engine", simulation.engine_name().c_str())) return;
  for (const EngineInfo& info : engine_table()) {
    const std::string name(info.name);
    if (ImGui::Selectable(name.c_str(), name == simulation.engine_name())) controller.use_engine(name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(info.summary).c_str());
  }
  ImGui::EndCombo();
}

void draw_buttons(Controller& controller) {
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  if (ImGui::Button(controller.paused() ? "Go on" : "Pause", {width, 0})) controller.act(Action::pause);
  ImGui::SameLine();
  if (ImGui::Button("Step", {width, 0})) controller.act(Action::step);
  ImGui::SameLine();
  if (ImGui::Button("Restart", {width, 0})) controller.act(Action::restart);
}

void draw_numbers(const Simulation& simulation) {
  heading("Pairs");
  row("frame", report::count_text(simulation.frame()));
  row("overlapping pairs", report::count_text(simulation.engine().pairs().size()));
  row("began, ended", report::count_text(simulation.began()) + ", " + report::count_text(simulation.ended()));
  const auto& colliding = simulation.colliding();
  const auto green = static_cast<std::size_t>(std::count(colliding.begin(), colliding.end(), true));
  row("green bodies", report::count_text(green));
}

// What of a line fits into the panel.
std::string cut_to_fit(const std::string& line) {
  const float width = ImGui::GetContentRegionAvail().x;
  if (ImGui::CalcTextSize(line.c_str()).x <= width) return line;
  constexpr const char* kMore = " ... (W)";
  std::string head = line;
  while (!head.empty() && ImGui::CalcTextSize((head + kMore).c_str()).x > width) {
    const std::size_t end = head.find_last_of(' ');
    head.resize(end == std::string::npos ? 0 : end);
  }
  return head + kMore;
}

// One line, so that what is below stays where it is; the rest where the mouse is, or by key.
void draw_complaint(const Controller& controller) {
  const std::string& complaint = controller.complaint();
  ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
  if (controller.shows_reason()) {
    ImGui::TextWrapped("%s", complaint.c_str());
  } else {
    ImGui::TextUnformatted(cut_to_fit(complaint).c_str());
  }
  ImGui::PopStyleColor();
  if (complaint.empty() || !ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(static_cast<float>(kPanelWidth));
  ImGui::TextUnformatted(complaint.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

// "spus, on SPEs".
std::string phase_name(const Phase& phase) {
  std::string name(phase.name);
  switch (phase.kind) {
    case PhaseKind::setup:
      return name + ", set-up";
    case PhaseKind::spes:
      return name + ", on SPEs";
    default:
      return name;
  }
}

void draw_times(const Simulation& simulation) {
  heading("Engine's time of a frame");
  draw_frame_times(simulation.frame_times());
  heading("Its phases in this frame");
  const std::vector<Phase>& phases = simulation.frame_time().phases;
  for (const Phase& phase : phases) row(phase_name(phase).c_str(), report::duration_text(phase.milliseconds));
  if (phases.empty()) ImGui::TextUnformatted("none: there was nothing to do");
}

void draw_first_ids(const Met& met) {
  constexpr std::size_t kLines = 3;
  constexpr std::size_t kOfLine = 5;
  for (std::size_t line = 0; line < kLines; ++line) {
    std::string ids;
    for (std::size_t i = kOfLine * line; i < std::min(kOfLine * (line + 1), met.size()); ++i)
      ids.append(ids.empty() ? "" : "  ").append(std::to_string(met[i].body));
    ImGui::TextUnformatted(ids.c_str());
  }
}

void draw_first_touches(const Met& met) {
  constexpr std::size_t kLines = 3;
  for (std::size_t i = 0; i < kLines; ++i) {
    const bool is_there = i < met.size();
    row(is_there ? ("body " + std::to_string(met[i].body)).c_str() : "",
        is_there ? report::factor_text(met[i].time) : "");
  }
}

// As many lines for any number of bodies, so that what is below stays where it is.
void draw_met(const Probe& probe, const Met& met) {
  if (probe.tool() == Tool::none) return;
  const bool is_ray = probe.tool() == Tool::ray;
  heading(is_ray ? "Ray: what it touches, and when" : "Box: what overlaps it");
  row("bodies", report::count_text(met.size()));
  if (is_ray) return draw_first_touches(met);
  draw_first_ids(met);
}

void draw_help() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x - 20, 20}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowBgAlpha(0.93F);
  ImGui::Begin("help", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize);
  for (const KeyBinding& binding : key_bindings()) {
    ImGui::TextUnformatted(binding.name.data(), binding.name.data() + binding.name.size());
    ImGui::SameLine(70);
    ImGui::TextUnformatted(binding.text.data(), binding.text.data() + binding.text.size());
  }
  ImGui::Separator();
  ImGui::TextColored(kFaint,
                     "Mouse: drag turns; with the right button it moves the box or ray, and\n"
                     "without one shifts, as with the middle button; the wheel zooms.");
  ImGui::End();
}

}  // namespace

void set_panel_style() {
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.WindowBorderSize = 0;
  style.WindowPadding = {16, 14};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 3};
  style.Colors[ImGuiCol_WindowBg] = {0.985F, 0.988F, 0.992F, 1};
  style.Colors[ImGuiCol_FrameBg] = {0.91F, 0.925F, 0.94F, 1};
  style.Colors[ImGuiCol_Text] = {0.13F, 0.16F, 0.20F, 1};
  style.Colors[ImGuiCol_Button] = {0.86F, 0.885F, 0.91F, 1};
  style.Colors[ImGuiCol_SliderGrab] = {0.26F, 0.62F, 0.31F, 1};
  style.Colors[ImGuiCol_SliderGrabActive] = {0.18F, 0.50F, 0.23F, 1};
  // Without it ImGui's own small font serves.
  if (std::filesystem::exists(kFont)) ImGui::GetIO().Fonts->AddFontFromFileTTF(kFont, kFontSize);
}

void Panel::draw(Controller& controller, const Met& met, float height) {
  if (controller.shows_help()) draw_help();
  if (!controller.shows_panel()) return;
  const Simulation& simulation = controller.simulation();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(kPanelWidth), height});
  ImGui::Begin("panel", nullptr, kFixed);
  ImGui::Text("cellsweep: %s", simulation.source_name().c_str());
  ImGui::Dummy({0, 2});
  draw_controls(controller);
  draw_complaint(controller);
  draw_numbers(simulation);
  draw_met(controller.probe(), met);
  draw_times(simulation);
  if (simulation.local_store()) {
    heading("Local stores");
    draw_local_stores(*simulation.local_store());
  }
  heading("H: keys");
  ImGui::End();
}

// The numbers stand above their sliders, where no knob is in the way.
void Panel::draw_controls(Controller& controller) {
  const Simulation& simulation = controller.simulation();
  if (!held_) {
    bodies_ = static_cast<int>(simulation.bodies());
    moving_percent_ = simulation.is_recording() ? 0 : static_cast<float>(100 * simulation.moving());
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8, 4});
  draw_engine_choice(controller);
  ImGui::BeginDisabled(simulation.is_recording());
  row("bodies", report::count_text(static_cast<std::size_t>(bodies_)));
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderInt("##bodies", &bodies_, kFewestBodies, kMostBodies, "", ImGuiSliderFlags_Logarithmic);
  held_ = ImGui::IsItemActive();
  if (ImGui::IsItemDeactivatedAfterEdit()) controller.use_bodies(static_cast<std::size_t>(bodies_));
  row("moving", simulation.is_recording() ? "as recorded" : percent_text(moving_percent_));
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderFloat("##moving", &moving_percent_, 0, 100, "");
  moving_percent_ = std::round(moving_percent_);
  held_ = held_ || ImGui::IsItemActive();
  if (ImGui::IsItemDeactivatedAfterEdit()) controller.use_moving(static_cast<double>(moving_percent_) / 100);
  ImGui::EndDisabled();
  draw_buttons(controller);
  ImGui::PopStyleVar();
}

}  // namespace cellsweep::view
