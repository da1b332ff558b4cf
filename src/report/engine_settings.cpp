#include "report/engine_settings.h"

#include <algorithm>

namespace cellsweep::report {

bool has_setting(const EngineInfo& engine, std::string_view setting) {
  return std::any_of(engine.settings.begin(), engine.settings.end(),
                     [&](const SettingInfo& info) { return info.name == setting; });
}

SettingValues values_for(std::string_view engine, const SettingValues& values) {
  SettingValues own;
  const EngineInfo* info = find_engine(engine);
  if (info == nullptr) return own;
  for (const auto& value : values) {
    if (has_setting(*info, value.first)) own.push_back(value);
  }
  return own;
}

std::string_view value_of(const SettingValues& values, std::string_view setting) {
  const auto found =
      std::find_if(values.rbegin(), values.rend(), [&](const auto& value) { return value.first == setting; });
  return found == values.rend() ? std::string_view() : std::string_view(found->second);
}

}  // namespace cellsweep::report
