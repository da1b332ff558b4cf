#include "bench/peers/chart/results.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
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

/// Takes what a file holds: of the rows of one name the one in the middle.
class Reader {
 public:
  explicit Reader(PeerResults& results) : results_(results), earlier_(results.cells) {}

  // A median that Google Benchmark took of repetitions is a measurement like others.
  void take_all(const json& rows) {
    for (const json& row : rows) note_measurement(row);
    for (const std::string& name : names_) take_middle(name, measured_.at(name));
    for (const json& row : rows) {
      if (is_aggregate(row, "cv") && measured_[name_of(row)].size() == 1)
        take_spread(name_of(row), row.value("real_time", 0.0));
    }
  }

 private:
  static std::string name_of(const json& row) { return row.value("run_name", ""); }

  void note_measurement(const json& row) {
    const std::string name = name_of(row);
    const bool is_one = row.value("run_type", "") == "iteration" || is_aggregate(row, "median");
    if (!is_one || row.value("error_occurred", false)) return;
    auto& of_name = measured_[name];
    if (of_name.empty()) names_.push_back(name);
    of_name.push_back(&row);
  }

  void take_middle(const std::string& name, std::vector<const json*> rows) {
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
    std::nth_element(rows.begin(), middle, rows.end(),
                     [](const json* a, const json* b) { return seconds_of(*a) < seconds_of(*b); });
    take(**middle, name);
    if (rows.size() > 1) take_spread(name, spread_of(rows));
  }

  // Standard deviation over mean.
  static double spread_of(const std::vector<const json*>& rows) {
    double sum = 0, squares = 0;
    for (const json* row : rows) sum += seconds_of(*row);
    const auto count = static_cast<double>(rows.size());
    const double mean = sum / count;
    for (const json* row : rows) squares += (seconds_of(*row) - mean) * (seconds_of(*row) - mean);
    return mean > 0 ? std::sqrt(squares / (count - 1)) / mean : 0;
  }

  void take(const json& row, const std::string& name) {
    const std::vector<std::string> parts = split(name);
    if (parts.front() == "p99") take_tail(row, parts);
    if (const auto cell = new_cell(parts)) take_time(row, *cell, parts[1]);
  }

  void take_spread(const std::string& name, double spread) {
    const std::vector<std::string> parts = split(name);
    if (const auto cell = new_cell(parts)) results_.cells[*cell][parts[1]].spread = spread;
  }

  // The cell of a row of a peer, unless an earlier file had that row.
  std::optional<CellKey> new_cell(const std::vector<std::string>& parts) const {
    const auto cell = cell_of(parts);
    return parts.front() == "peers" && cell && !is_old(*cell, parts[1]) ? cell : std::nullopt;
  }

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
  std::map<std::string, std::vector<const json*>> measured_;
  std::vector<std::string> names_;  // of those, in the order of the file
};

}  // namespace

Status add_results(std::string_view text_of_file, PeerResults& results) {
  const Status refused = Status::bad_input("This is no JSON that Google Benchmark wrote.");
  const json file = json::parse(without_nan(text_of_file), nullptr, false);
  if (file.is_discarded() || !file.is_object() || !file.contains("benchmarks")) return refused;
  try {
    PeerResults more = results;
    if (more.machine.empty() && file.contains("context")) more.machine = machine_of(file["context"]);
    Reader(more).take_all(file["benchmarks"]);
    results = std::move(more);
  } catch (const json::exception&) {
    return refused;
  }
  return {};
}

}  // namespace cellsweep::bench
