#include <algorithm>
#include <array>
#include <string>

#include "broadphase/text.h"
#include "cellsweep/engines.h"
#include "engines/control/control.h"

namespace cellsweep {
namespace {

using Factory = Result<std::unique_ptr<Broadphase>> (*)(const EngineOptions&);

struct Entry {
  EngineInfo info;
  Factory make;
};

constexpr std::array kEntries = {
    Entry{{"control",
           "the document's x86 sweep and prune: three insertion-sorted axes, a map of all possible pairs"},
          make_control},
};

constexpr auto kTable = [] {
  std::array<EngineInfo, kEntries.size()> table{};
  std::transform(kEntries.begin(), kEntries.end(), table.begin(),
                 [](const Entry& entry) { return entry.info; });
  return table;
}();

Status unknown_engine_status(std::string_view name) {
  std::string known;
  for (const EngineInfo& info : kTable) known += (known.empty() ? "" : ", ") + std::string(info.name);
  return {StatusCode::bad_option,
          text("There is no engine \"", name, "\"; there are: ", known, "."),
          std::nullopt,
          0,
          0,
          "engine"};
}

}  // namespace

std::span<const EngineInfo> engine_table() {
  return kTable;
}

Result<std::unique_ptr<Broadphase>> make_engine(std::string_view name, const EngineOptions& options) {
  const auto entry = std::find_if(kEntries.begin(), kEntries.end(),
                                  [&](const Entry& candidate) { return candidate.info.name == name; });
  if (entry == kEntries.end()) return unknown_engine_status(name);
  return entry->make(options);
}

}  // namespace cellsweep
