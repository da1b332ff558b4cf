#include "bench/cell_suite.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bench/engine_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::size_t, 2> kBodies = {256, 1024};

struct Setting {
  std::string name;
  EngineOptions options;
};

/// A setting that differs from the defaults in one member.
template <class Value>
Setting with(std::string name, Value EngineOptions::*member, Value value) {
  Setting setting{std::move(name), {}};
  setting.options.*member = value;
  return setting;
}

std::vector<Setting> settings_of(std::string_view engine) {
  std::vector<Setting> settings = {
      {"default", {}},
      with("isa", &EngineOptions::spe_engine, SpeEngine::isa),
      with("dma_late", &EngineOptions::dma, DmaMode::late),
      with("dma_unchecked", &EngineOptions::dma, DmaMode::unchecked),
      with("local_store_128K", &EngineOptions::local_store_bytes, std::uint64_t{128} << 10),
      with("local_store_1M", &EngineOptions::local_store_bytes, std::uint64_t{1} << 20),
      with("local_store_off", &EngineOptions::local_store_bytes, std::uint64_t{0}),
      with("trace", &EngineOptions::trace_file, std::string("/dev/null"))};
  if (engine == "cell-paper") {
    settings.push_back(with("method_2", &EngineOptions::method, 2U));
    settings.push_back(with("list_dma", &EngineOptions::list_dma, true));
    Setting both = with("method_2_list_dma", &EngineOptions::method, 2U);
    both.options.list_dma = true;
    settings.push_back(both);
    settings.push_back(with("literal", &EngineOptions::literal, true));
    return settings;
  }
  if (engine == "cell-resident") settings.push_back(with("spu_boxes", &EngineOptions::spu_boxes, true));
  for (const unsigned spus : {1U, 2U, 6U}) {
    settings.push_back(with("spus_" + std::to_string(spus), &EngineOptions::spus, spus));
  }
  return settings;
}

/// On its own vectors, and through local stores: what that discipline costs.
std::vector<Setting> settings_of_stream() {
  Setting isa = with("on_spes_isa", &EngineOptions::on_spes, true);
  isa.options.spe_engine = SpeEngine::isa;
  return {{"default", {}}, with("on_spes", &EngineOptions::on_spes, true), isa};
}

// Settings that an engine refuses, and sizes beyond its capacity, have no row.
void register_rows(const std::string& engine, const Setting& setting) {
  const auto sample = make_engine(engine, setting.options);
  if (!sample) return;
  for (const std::size_t bodies : kBodies) {
    if (bodies > (*sample)->capacity().bodies) continue;
    for (const ModeInfo& mode : kModes) {
      register_engine_row(
          "cell/" + engine + "/" + setting.name + "/" + std::to_string(bodies) + "/" + std::string(mode.name),
          {engine, setting.options, SceneSettings{.bodies = bodies, .moving = mode.moving}, mode.mode});
    }
  }
}

}  // namespace

void register_cell_suite() {
  for (const EngineInfo& engine : engine_table()) {
    if (engine.name == "stream") {
      for (const Setting& setting : settings_of_stream()) register_rows("stream", setting);
    }
    if (!engine.name.starts_with("cell-")) continue;
    for (const Setting& setting : settings_of(engine.name)) register_rows(std::string(engine.name), setting);
  }
}

}  // namespace cellsweep::bench
