#include "bench/engine_suite.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "bench/engine_row.h"
#include "report/oracle.h"

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

// More would take the oracle minutes a row.
std::uint64_t most_bodies(const Broadphase& engine) {
  const std::uint64_t capacity = engine.capacity().bodies;
  return engine.name() == report::kOracle ? std::min<std::uint64_t>(capacity, report::kMostBodiesOfOracle)
                                          : capacity;
}

std::span<const ModeInfo> modes_of(const SceneInfo& scene) {
  const bool moves_as_told = scene.is_world && scene.moving == SceneInfo{}.moving;
  return moves_as_told ? std::span<const ModeInfo>(kModes) : std::span<const ModeInfo>(kOwnModes);
}

}  // namespace

void register_engine_suite() {
  for (const EngineInfo& engine : engine_table()) {
    const auto sample = make_broadphase(engine.name);
    if (!sample) continue;
    const std::uint64_t most = most_bodies(*sample);
    for (const SceneInfo& scene : scene_table()) {
      for (const std::size_t bodies : kBodies) {
        if (bodies > most) continue;
        for (const ModeInfo& mode : modes_of(scene)) register_row(engine, scene, bodies, mode);
      }
    }
  }
}

}  // namespace cellsweep::bench
