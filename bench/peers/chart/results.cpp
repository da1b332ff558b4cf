#include "bench/peers/chart/results.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "bench/peers/peer_mode.h"

namespace cellsweep::bench {
namespace {

using nlohmann::json;

std::vector<std::string> split(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '/') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<CellKey> cell_of(const std::vector<std::string>& parts) {
  if (parts.size() < 5) return std::nullopt;
  CellKey cell;
  cell.scene = static_cast<std::size_t>(std::find(kPeerScenes.begin(), kPeerScenes.end(), parts[2]) -
                                        kPeerScenes.begin());
  cell.mode =
      static_cast<std::size_t>(std::find_if(kPeerModes.begin(), kPeerModes.end(),
                                            [&](const PeerModeInfo& info) { return info.name == parts[4]; }) -
                               kPeerModes.begin());
  const char* end = parts[3].data() + parts[3].size();
  if (std::from_chars(parts[3].data(), end, cell.bodies).ptr != end) return std::nullopt;
  if (cell.scene == kPeerScenes.size() || cell.mode == kPeerModes.size()) return std::nullopt;
  return cell;
}

double seconds_of(const json& row) {
  const std::string unit = row.value("time_unit", "ns");
  const double scale = unit == "s" ? 1 : unit == "ms" ? 1e-3 : unit == "us" ? 1e-6 : 1e-9;
  return row.value("real_time", 0.0) * scale;
}

bool is_aggregate(const json& row, std::string_view name) {
  return row.value("run_type", "") == "aggregate" && row.value("aggregate_name", "") == name;
}

std::string machine_of(const json& context) {
  const std::string giant = context.value("giant", "");
  return (giant.empty() ? "" : "with a giant (" + giant + "): ") + context.value("cpu", "") + ", " +
         context.value("cores", "") + " cores, " + context.value("compiler", "") + ", commit " +
         context.value("commit", "");
}

// Google Benchmark writes the spread of counters that are zero as NaN, which JSON has not.
std::string without_nan(std::string_view text_of_file) {
  std::string result(text_of_file);
  for (const std::string_view nan : {": NaN", ": -NaN"}) {
    for (std::size_t at = result.find(nan); at != std::string::npos; at = result.find(nan, at)) {
      result.replace(at, nan.size(), ": 0");
    }
  }
  return result;
}

/// Takes one row after the other.
class Reader {
 public:
  explicit Reader(PeerResults& results) : results_(results), earlier_(results.cells) {}

  // Single runs only of rows that come without medians: those of a row with medians are said before them.
  void take(const json& row) {
    const std::string name = row.value("run_name", "");
    const std::vector<std::string> parts = split(name);
    const bool is_value = is_aggregate(row, "median") || row.value("run_type", "") == "iteration";
    if (parts.front() == "p99" && is_value) take_tail(row, parts);
    const auto cell = cell_of(parts);
    if (parts.front() != "peers" || !cell || is_old(*cell, parts[1])) return;
    if (is_value) take_time(row, *cell, parts[1]);
    if (is_aggregate(row, "cv")) results_.cells[*cell][parts[1]].spread = row.value("real_time", 0.0);
  }

 private:
  bool is_old(const CellKey& cell, const std::string& peer) const {
    const auto found = earlier_.find(cell);
    return found != earlier_.end() && found->second.contains(peer);
  }

  void take_time(const json& row, const CellKey& cell, const std::string& peer) {
    auto& known = results_.peers;
    if (std::find(known.begin(), known.end(), peer) == known.end()) known.push_back(peer);
    PeerTime& time = results_.cells[cell][peer];
    time.seconds = seconds_of(row);
    time.median = 1e-6 * row.value("median", 0.0);
    time.p99 = 1e-6 * row.value("p99", 0.0);
    time.pairs = row.value("pairs", 0.0);
    time.missing = row.value("missing", 0.0);
    time.extra = row.value("extra", 0.0);
  }

  void take_tail(const json& row, const std::vector<std::string>& parts) {
    const auto cell = cell_of(parts);
    if (!cell) return;
    auto& tails = results_.tails;
    auto found =
        std::find_if(tails.begin(), tails.end(), [&](const Tail& tail) { return tail.cell == *cell; });
    if (found == tails.end()) found = tails.insert(tails.end(), Tail{*cell});
    found->median_seconds = seconds_of(row);
    found->p99_over_median = row.value("p99/median", 0.0);
    found->mean_over_median = row.value("mean/median", 0.0);
    found->frames = row.value("frames", 0.0);
  }

  PeerResults& results_;
  const std::map<CellKey, std::map<std::string, PeerTime>> earlier_;
};

}  // namespace

Status add_results(std::string_view text_of_file, PeerResults& results) {
  const Status refused = Status::bad_input("This is no JSON that Google Benchmark wrote.");
  const json file = json::parse(without_nan(text_of_file), nullptr, false);
  if (file.is_discarded() || !file.is_object() || !file.contains("benchmarks")) return refused;
  try {
    PeerResults more = results;
    if (more.machine.empty() && file.contains("context")) more.machine = machine_of(file["context"]);
    Reader reader(more);
    for (const json& row : file["benchmarks"]) reader.take(row);
    results = std::move(more);
  } catch (const json::exception&) {
    return refused;
  }
  return {};
}

}  // namespace cellsweep::bench
