#include "view/panel_charts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "report/all_engines.h"
#include "report/quantile.h"
#include "report/units.h"
#include "view/simulation.h"

namespace cellsweep::view {
namespace {

constexpr ImU32 kBar = IM_COL32(66, 158, 79, 255);
constexpr ImU32 kCutOff = IM_COL32(230, 159, 0, 255);
constexpr ImU32 kGround = IM_COL32(232, 236, 240, 255);
constexpr ImU32 kLine = IM_COL32(150, 160, 172, 255);
constexpr ImU32 kInk = IM_COL32(60, 68, 80, 255);

constexpr std::array<ImU32, 16> kRegions = {
    IM_COL32(70, 80, 96, 255),    IM_COL32(130, 140, 154, 255), IM_COL32(186, 194, 204, 255),
    IM_COL32(120, 94, 60, 255),   IM_COL32(0, 114, 178, 255),   IM_COL32(86, 180, 233, 255),
    IM_COL32(0, 158, 115, 255),   IM_COL32(230, 159, 0, 255),   IM_COL32(213, 94, 0, 255),
    IM_COL32(204, 121, 167, 255), IM_COL32(122, 82, 160, 255),  IM_COL32(240, 228, 66, 255),
    IM_COL32(150, 30, 50, 255),   IM_COL32(60, 190, 180, 255),  IM_COL32(170, 200, 90, 255),
    IM_COL32(20, 60, 110, 255)};

/// The largest of 1, 2, 5, 10 ... times a power of ten that leaves room above `most`.
float round_top(float most) {
  const float power = std::pow(10.0F, std::floor(std::log10(std::max(most, 1e-4F))));
  for (const float step : {1.0F, 2.0F, 5.0F}) {
    if (most <= step * power) return step * power;
  }
  return 10 * power;
}

ImVec2 reserve(float height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, height});
  return corner;
}

void draw_strip(const LocalStoreMap& map, unsigned spe, float label_width) {
  constexpr float kHeight = 15;
  ImGui::Text("SPE %u", spe);
  ImGui::SameLine(label_width);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({width, kHeight});
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const double whole = static_cast<double>(std::max(map.limit, report::used_bytes(map)));
  draw.AddRectFilled(corner, {corner.x + width, corner.y + kHeight}, kGround);
  double used = 0;
  for (std::size_t part = 0; part < map.parts.size(); ++part) {
    const auto from = static_cast<float>(used / whole);
    used += static_cast<double>(map.parts[part].bytes);
    const auto to = static_cast<float>(used / whole);
    draw.AddRectFilled({corner.x + width * from, corner.y}, {corner.x + width * to, corner.y + kHeight},
                       kRegions[part % kRegions.size()]);
  }
}

void draw_region_name(std::size_t part, const LocalStorePart& region) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float edge = 0.6F * ImGui::GetTextLineHeight();
  const float top = corner.y + 0.25F * ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, top}, {corner.x + edge, top + edge},
                                            kRegions[part % kRegions.size()]);
  ImGui::Dummy({edge, 0});
  ImGui::SameLine();
  ImGui::Text("%s", region.name.c_str());
  char bytes[32];
  std::snprintf(bytes, sizeof bytes, "%.1f KB", static_cast<double>(region.bytes) / 1024);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(bytes).x);
  ImGui::TextUnformatted(bytes);
}

}  // namespace

void draw_frame_times(const std::vector<float>& times) {
  constexpr float kHeight = 70;
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = reserve(kHeight);
  const float floor = corner.y + kHeight;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + width, floor}, kGround, 3);
  if (times.empty()) return;
  const std::vector<double> sorted(times.begin(), times.end());
  const double longest = report::quantile(sorted, 1.0);
  const double median = report::quantile(sorted, 0.5);
  // A single long frame does not make all others look like nothing.
  const float top = round_top(1.2F * static_cast<float>(report::quantile(sorted, 0.95)));
  const float step = width / static_cast<float>(Simulation::kRememberedFrames);
  float x = corner.x + width - step * static_cast<float>(times.size());
  for (const float time : times) {
    const float height = kHeight * std::min(time / top, 1.0F);
    draw.AddRectFilled({x, floor - height}, {x + std::max(step, 1.0F), floor}, time > top ? kCutOff : kBar);
    x += step;
  }
  draw.AddLine({corner.x, floor - kHeight / 2}, {corner.x + width, floor - kHeight / 2}, kLine);
  draw.AddText({corner.x + 4, corner.y + 2}, kInk, report::duration_text(static_cast<double>(top)).c_str());
  draw.AddText({corner.x + 4, floor - kHeight / 2 + 1}, kInk,
               report::duration_text(static_cast<double>(top / 2)).c_str());
  ImGui::Text("median %s, longest %s", report::duration_text(median).c_str(),
              report::duration_text(longest).c_str());
}

void draw_local_stores(const LocalStoreMap& map) {
  const float label_width = ImGui::CalcTextSize("SPE 00").x + 2 * ImGui::GetStyle().WindowPadding.x;
  for (unsigned spe = 0; spe < map.spus; ++spe) draw_strip(map, spe, label_width);
  ImGui::Dummy({0, 1});
  for (std::size_t part = 0; part < map.parts.size(); ++part) draw_region_name(part, map.parts[part]);
  const double kilobytes = static_cast<double>(report::used_bytes(map)) / 1024;
  if (map.limit == 0) {
    ImGui::Text("%.1f KB used each, no limit", kilobytes);
  } else {
    ImGui::Text("%.1f of %.0f KB used each", kilobytes, static_cast<double>(map.limit) / 1024);
  }
}

}  // namespace cellsweep::view
