/// @file
/// One benchmark of one engine: how a row is checked and timed, for all suites.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "cellsweep/engines.h"
#include "cellsweep/world/scene.h"

namespace cellsweep::bench {

/// initial: all bodies at once into a new engine. settled: frames in which nothing moves. moving: some move.
enum class Mode { initial, settled, moving };

struct ModeInfo {
  std::string_view name;
  Mode mode;
  std::optional<double> moving;  ///< share of the bodies; none: the scene's own
};

inline constexpr std::array kModes = {
    ModeInfo{"initial", Mode::initial, 0.0}, ModeInfo{"static", Mode::settled, 0.0},
    ModeInfo{"moving10", Mode::moving, 0.1}, ModeInfo{"moving100", Mode::moving, 1.0}};

/// For scenes with a motion of their own.
inline constexpr std::array kOwnModes = {ModeInfo{"initial", Mode::initial, std::nullopt},
                                         ModeInfo{"static", Mode::settled, std::nullopt},
                                         ModeInfo{"own", Mode::moving, std::nullopt}};

/// What a row runs.
struct EngineRow {
  std::string engine;
  SettingValues settings;
  SceneSettings scene;
  Mode mode = Mode::initial;
};

/// Registers a row under this name. It is compared with the oracle before it is timed and skipped with an
/// error when they differ, but for rows of the document's literal logic. The time is that of handing over the
/// boxes that changed and of update(), without phases marked as set-up. Counters: `pairs`, and `boxes/s`, all
/// bodies of the scene over the time of one frame; the label is the pairs' hash.
void register_engine_row(const std::string& name, const EngineRow& row);

}  // namespace cellsweep::bench
