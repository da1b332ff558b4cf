#include "bench/peers/chart/results.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bench/measured/measured_rows.h"
#include "bench/peers/peer_mode.h"

namespace cellsweep::bench {
namespace {

std::optional<CellKey> cell_of(const std::vector<std::string>& parts) {
  if (parts.size() < 5) return std::nullopt;
  const auto scene = std::find(kPeerScenes.begin(), kPeerScenes.end(), parts[2]);
  const auto bodies = number_in(parts[3]);
  const auto mode = std::find_if(kPeerModes.begin(), kPeerModes.end(),
                                 [&](const PeerModeInfo& info) { return info.name == parts[4]; });
  if (scene == kPeerScenes.end() || !bodies || mode == kPeerModes.end()) return std::nullopt;
  return CellKey{static_cast<std::size_t>(scene - kPeerScenes.begin()), *bodies,
                 static_cast<std::size_t>(mode - kPeerModes.begin())};
}

PeerTime time_of(const MeasuredRow& row) {
  PeerTime time;
  time.seconds = row.seconds;
  time.median = 1e-6 * row.counter("median");
  time.p99 = 1e-6 * row.counter("p99");
  time.spread = row.spread;
  time.pairs = row.counter("pairs");
  time.missing = row.counter("missing");
  time.extra = row.counter("extra");
  time.turns = row.turns;
  return time;
}

void take_peer(const MeasuredRow& row, const CellKey& cell, PeerResults& results) {
  const std::string& peer = row.parts[1];
  if (!results.cells[cell].try_emplace(peer, time_of(row)).second) return;
  auto& known = results.peers;
  if (std::find(known.begin(), known.end(), peer) == known.end()) known.push_back(peer);
}

void take_tail(const MeasuredRow& row, const CellKey& cell, PeerResults& results) {
  auto& tails = results.tails;
  auto found = std::find_if(tails.begin(), tails.end(), [&](const Tail& tail) { return tail.cell == cell; });
  if (found == tails.end()) found = tails.insert(tails.end(), Tail{cell});
  found->median_seconds = row.seconds;
  found->p99_over_median = row.counter("p99/median");
  found->mean_over_median = row.counter("mean/median");
  found->frames = row.counter("frames");
}

}  // namespace

Status add_results(std::string_view text_of_file, PeerResults& results) {
  const Result<MeasuredRows> measured = read_measured_rows(text_of_file);
  if (!measured) return measured.status();
  PeerResults more = results;
  if (more.machine.empty()) more.machine = measured->machine;
  for (const MeasuredRow& row : measured->rows) {
    const auto cell = cell_of(row.parts);
    if (cell && row.parts.front() == "peers") take_peer(row, *cell, more);
    if (cell && row.parts.front() == "p99") take_tail(row, *cell, more);
  }
  results = std::move(more);
  return {};
}

}  // namespace cellsweep::bench
