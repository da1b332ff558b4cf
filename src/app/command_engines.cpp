#include "app/commands.h"
#include "app/output.h"
#include "app/setting_flags.h"
#include "cellsweep/engines.h"
#include "report/table.h"
#include "report/units.h"

namespace cellsweep::app {
namespace {

std::vector<std::string> flags_of(const EngineInfo& info) {
  std::vector<std::string> flags;
  for (const SettingInfo& setting : info.settings) flags.push_back(flag_of(setting.name));
  return flags;
}

ExitCode list_engines(bool json) {
  auto rows = nlohmann::ordered_json::array();
  report::Table table({"engine", "what it is", "bodies at most"}, 2);
  for (const EngineInfo& info : engine_table()) {
    const auto engine = make_broadphase(info.name);
    if (!engine) return complain(engine.status());
    const Capacity capacity = engine->capacity();
    rows.push_back({{"engine", info.name},
                    {"summary", info.summary},
                    {"max_bodies", capacity.bodies},
                    {"limited_by", capacity.reason},
                    {"raise", capacity.setting.empty() ? "" : flag_of(capacity.setting)},
                    {"flags", flags_of(info)}});
    table.add({std::string(info.name), std::string(info.summary), report::count_text(capacity.bodies)});
  }
  if (json) {
    print_json({{"engines", rows}});
  } else {
    print_text(table.text());
  }
  return kGood;
}

}  // namespace

void add_engines(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand("engines", "List the engines and what they hold by default");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One JSON object on standard output");
  command->callback([json, &exit_code] { exit_code = list_engines(*json); });
}

}  // namespace cellsweep::app
