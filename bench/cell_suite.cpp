#include "bench/cell_suite.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bench/engine_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::size_t, 2> kBodies = {256, 1024};

/// Settings that differ from the defaults, by the name of their rows.
struct Setting {
  std::string name;
  SettingValues values;
};

std::vector<Setting> settings_of(std::string_view engine) {
  std::vector<Setting> settings = {{"default", {}},
                                   {"isa", {{"spe_engine", "isa"}}},
                                   {"dma_late", {{"dma", "late"}}},
                                   {"dma_unchecked", {{"dma", "unchecked"}}},
                                   {"local_store_128K", {{"local_store", std::to_string(128 << 10)}}},
                                   {"local_store_1M", {{"local_store", std::to_string(1 << 20)}}},
                                   {"local_store_off", {{"local_store", "0"}}},
                                   {"trace", {{"trace", "/dev/null"}}}};
  if (engine == "cell-paper") {
    settings.push_back({"method_2", {{"method", "2"}}});
    settings.push_back({"list_dma", {{"list_dma", "true"}}});
    settings.push_back({"method_2_list_dma", {{"method", "2"}, {"list_dma", "true"}}});
    settings.push_back({"literal", {{"literal", "true"}}});
    return settings;
  }
  if (engine == "cell-resident") settings.push_back({"spu_boxes", {{"spu_boxes", "true"}}});
  for (const std::string spus : {"1", "2", "6"}) settings.push_back({"spus_" + spus, {{"spus", spus}}});
  return settings;
}

// Settings that an engine refuses, and sizes beyond its capacity, have no row.
void register_rows(const std::string& engine, const SettingValues& values, const std::string& name) {
  const auto sample = make_broadphase(engine, values);
  if (!sample) return;
  for (const std::size_t bodies : kBodies) {
    if (bodies > sample->capacity().bodies) continue;
    for (const ModeInfo& mode : kModes) {
      register_engine_row(
          "cell/" + name + "/" + std::to_string(bodies) + "/" + std::string(mode.name),
          {engine, values, SceneSettings{.bodies = bodies, .moving = mode.moving}, mode.mode});
    }
  }
}

}  // namespace

void register_cell_suite() {
  for (const std::string engine : {"cell-paper", "cell-brute", "cell-resident"}) {
    for (const Setting& setting : settings_of(engine))
      register_rows(engine, setting.values, engine + "/" + setting.name);
  }
  // On its own vectors, and through local stores: what that discipline costs.
  register_rows("stream", {}, "stream/default");
  register_rows("cell-stream", {}, "stream/on_spes");
  register_rows("cell-stream", {{"spe_engine", "isa"}}, "stream/on_spes_isa");
}

}  // namespace cellsweep::bench
