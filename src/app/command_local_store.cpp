#include "app/checks.h"
#include "app/commands.h"
#include "app/engine_flags.h"
#include "app/output.h"
#include "report/all_engines.h"
#include "report/engine_settings.h"
#include "report/table.h"

namespace cellsweep::app {
namespace {

bool fits(const LocalStoreMap& map) {
  return map.limit == 0 || report::used_bytes(map) <= map.limit;
}

void print_map(const LocalStoreMap& map) {
  const std::uint64_t used = report::used_bytes(map);
  report::Table table({"part", "bytes"}, 1);
  for (const LocalStorePart& part : map.parts) table.add({part.name, std::to_string(part.bytes)});
  table.add({"together", std::to_string(used)});
  if (map.limit != 0) {
    table.add({"limit", std::to_string(map.limit)});
    table.add(
        {fits(map) ? "free" : "too many", std::to_string(fits(map) ? map.limit - used : used - map.limit)});
  }
  print_text(map.engine + ", " + std::to_string(map.bodies) + " bodies, local store of one SPE\n" +
             table.text());
}

nlohmann::ordered_json json_of(const LocalStoreMap& map) {
  auto parts = nlohmann::ordered_json::array();
  for (const LocalStorePart& part : map.parts) parts.push_back({{"name", part.name}, {"bytes", part.bytes}});
  return {{"engine", map.engine},     {"bodies", map.bodies},
          {"limit_bytes", map.limit}, {"used_bytes", report::used_bytes(map)},
          {"fits", fits(map)},        {"parts", parts}};
}

struct LocalStore {
  std::uint64_t bodies = 1024;
  EngineFlags engines;
  bool json = false;

  ExitCode run() const {
    if (const Status status = engines.check(); !status.ok()) return complain(status);
    bool all_fit = true;
    auto maps = nlohmann::ordered_json::array();
    for (const std::string& name : engines.names()) {
      const auto map = report::local_store_of(name, report::values_for(name, engines.values()), bodies);
      if (!map) return complain(map.status());
      all_fit = all_fit && fits(*map);
      if (json) maps.push_back(json_of(*map));
      if (!json) print_map(*map);
    }
    if (json) print_json({{"maps", maps}});
    return all_fit ? kGood : kCapacity;
  }
};

}  // namespace

void add_local_store(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command =
      program.add_subcommand("local-store", "Show what a Cell engine puts into the local store of an SPE");
  auto local_store = std::make_shared<LocalStore>();
  local_store->engines.add_to(*command, EngineFlags::Purpose::a_look, "cell-paper");
  command->add_option("--bodies", local_store->bodies, "Bodies to lay out")
      ->check(count())
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--json", local_store->json, "One JSON object on standard output");
  command->footer(
      "Exit code 3 when it does not fit.\n"
      "Example:\n"
      "  cellsweep local-store --engine cell-brute --bodies 4000");
  command->callback([local_store, &exit_code] { exit_code = local_store->run(); });
}

}  // namespace cellsweep::app
