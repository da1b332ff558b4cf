/// @file
/// What a run over ranks took and found, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/ranks/rank_run.h"

namespace cellsweep::app {

std::string rank_tables(const std::string& source, const RankReport& report);
nlohmann::ordered_json rank_json(const std::string& source, const RankReport& report);

/// The timeline as a file that opens in Perfetto, a row a rank.
std::string rank_timeline(const RankReport& report);

}  // namespace cellsweep::app
