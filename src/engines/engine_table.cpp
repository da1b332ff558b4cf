#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "cellsweep/engines.h"
#include "engines/core_engines.h"

namespace cellsweep {
namespace {

std::vector<EngineInfo>& table() {
  static std::vector<EngineInfo> engines = core_engines();
  return engines;
}

Status unknown_engine_status(std::string_view name) {
  std::string known;
  for (const EngineInfo& info : table()) known += text(known.empty() ? "" : ", ", info.name);
  return Status::bad_option("engine", text("There is no engine \"", name, "\"; there are: ", known, "."));
}

}  // namespace

std::span<const EngineInfo> engine_table() {
  return table();
}

void add_engine(EngineInfo info) {
  const auto same =
      std::ranges::find_if(table(), [&](const EngineInfo& known) { return known.name == info.name; });
  if (same == table().end()) {
    table().push_back(std::move(info));
  } else {
    *same = std::move(info);
  }
}

const EngineInfo* find_engine(std::string_view name) {
  const auto found = std::ranges::find_if(table(), [&](const EngineInfo& info) { return info.name == name; });
  return found == table().end() ? nullptr : &*found;
}

Result<Broadphase> make_broadphase(std::string_view engine, const SettingValues& settings) {
  const EngineInfo* info = find_engine(engine);
  return info == nullptr ? unknown_engine_status(engine) : info->make(settings);
}

}  // namespace cellsweep
