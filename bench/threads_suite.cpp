#include "bench/threads_suite.h"

#include <array>
#include <string>

#include "bench/engine_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::size_t, 3> kBodies = {1000, 10'000, 100'000};
constexpr std::array<unsigned, 6> kThreads = {0, 1, 2, 4, 8, 16};

void register_row(std::size_t bodies, const ModeInfo& mode, unsigned threads) {
  EngineRow row;
  row.engine = "stream";
  row.settings = {{"threads", std::to_string(threads)}};
  row.scene.scene = "uniform";
  row.scene.bodies = bodies;
  row.scene.moving = mode.moving;
  row.mode = mode.mode;
  register_engine_row("threads/" + std::to_string(bodies) + "/" + std::string(mode.name) + "/" +
                          (threads == 0 ? "auto" : std::to_string(threads)),
                      row);
}

}  // namespace

void register_threads_suite() {
  for (const std::size_t bodies : kBodies) {
    for (const ModeInfo& mode : kModes) {
      if (mode.mode == Mode::settled) continue;
      for (const unsigned threads : kThreads) register_row(bodies, mode, threads);
    }
  }
}

}  // namespace cellsweep::bench
