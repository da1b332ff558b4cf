#include "bench/engine_suite.h"

#include <array>
#include <string>

#include "bench/engine_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::size_t, 9> kBodies = {64, 128, 256, 512, 1024, 4096, 10'000, 100'000, 1'000'000};

void register_row(const EngineInfo& engine, const SceneInfo& scene, std::size_t bodies,
                  const ModeInfo& mode) {
  EngineRow row;
  row.engine = engine.name;
  row.scene.scene = scene.name;
  row.scene.bodies = bodies;
  row.scene.moving = mode.moving;
  row.mode = mode.mode;
  register_engine_row("engine/" + row.engine + "/" + row.scene.scene + "/" + std::to_string(bodies) + "/" +
                          std::string(mode.name),
                      row);
}

}  // namespace

void register_engine_suite() {
  for (const EngineInfo& engine : engine_table()) {
    const auto sample = make_engine(engine.name);
    if (!sample) continue;
    for (const SceneInfo& scene : scene_table()) {
      for (const std::size_t bodies : kBodies) {
        if (bodies > (*sample)->capacity().bodies) continue;
        for (const ModeInfo& mode : kModes) register_row(engine, scene, bodies, mode);
      }
    }
  }
}

}  // namespace cellsweep::bench
