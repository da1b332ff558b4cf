#include "bench/peers/chart/ratios.h"

#include <algorithm>
#include <cmath>

namespace cellsweep::bench {

bool is_other(std::string_view peer) {
  return peer != "memory" && !peer.starts_with("stream") && !peer.starts_with("cell-");
}

std::vector<CellRatio> ratios_of(const PeerResults& results) {
  std::vector<CellRatio> ratios;
  for (const auto& [cell, times] : results.cells) {
    const auto stream = times.find("stream");
    if (stream == times.end()) continue;
    CellRatio ratio;
    ratio.cell = cell;
    ratio.stream = stream->second;
    ratio.pairs = stream->second.pairs;
    if (const auto memory = times.find("memory"); memory != times.end())
      ratio.memory = memory->second.seconds;
    for (const auto& [peer, time] : times) {
      if (!is_other(peer) || !time.exact()) continue;
      if (!ratio.best.empty() && time.seconds >= ratio.best_time.seconds) continue;
      ratio.best = peer;
      ratio.best_time = time;
    }
    if (!ratio.best.empty()) ratios.push_back(ratio);
  }
  return ratios;
}

std::optional<RatioSummary> summarise(const std::vector<CellRatio>& ratios) {
  if (ratios.empty()) return std::nullopt;
  double logarithms = 0;
  for (const CellRatio& ratio : ratios) logarithms += std::log(ratio.ratio());
  const auto smallest =
      std::min_element(ratios.begin(), ratios.end(),
                       [](const CellRatio& a, const CellRatio& b) { return a.ratio() < b.ratio(); });
  return RatioSummary{std::exp(logarithms / static_cast<double>(ratios.size())), *smallest};
}

}  // namespace cellsweep::bench
