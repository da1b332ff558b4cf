#include "bench/queries/table/query_results.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <vector>

#include "bench/queries/query_world.h"
#include "bench/queries/question.h"

namespace cellsweep::bench {
namespace {

using nlohmann::json;

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream rest(name);
  for (std::string part; std::getline(rest, part, '/');) parts.push_back(part);
  return parts;
}

/// The place of a world's name among all; none when there is no such world.
std::optional<std::size_t> world_of(const std::string& name) {
  const auto world = std::find(kQueryWorlds.begin(), kQueryWorlds.end(), name);
  if (world == kQueryWorlds.end()) return std::nullopt;
  return static_cast<std::size_t>(world - kQueryWorlds.begin());
}

/// From frames/WORLD/N/rays/PERCENT/NAME.
std::optional<FrameCell> frame_of_row(const std::vector<std::string>& parts) {
  if (parts.size() < 6 || parts[0] != "frames") return std::nullopt;
  const auto world = world_of(parts[1]);
  std::istringstream bodies(parts[2]);
  std::istringstream percent(parts[4]);
  FrameCell cell;
  if (!world || !(bodies >> cell.bodies) || !(percent >> cell.percent)) return std::nullopt;
  cell.world = *world;
  return cell;
}

/// From queries/WORLD/N/KIND/NAME or moved/WORLD/N/KIND/NAME.
std::optional<QueryCell> cell_of_row(const std::vector<std::string>& parts) {
  if (parts.size() < 5 || (parts[0] != "queries" && parts[0] != "moved")) return std::nullopt;
  const auto world = world_of(parts[1]);
  const auto kind = std::find_if(kQuestionKinds.begin(), kQuestionKinds.end(),
                                 [&](const QuestionKindInfo& info) { return info.name == parts[3]; });
  std::istringstream number(parts[2]);
  QueryCell cell;
  if (!world || kind == kQuestionKinds.end() || !(number >> cell.bodies)) return std::nullopt;
  cell.is_moved = parts[0] == "moved";
  cell.world = *world;
  cell.kind = static_cast<std::size_t>(kind - kQuestionKinds.begin());
  return cell;
}

void take_row(const json& row, QueryResults& results) {
  const bool is_value =
      row.value("aggregate_name", "") == "median" || row.value("run_type", "") == "iteration";
  const std::vector<std::string> parts = parts_of(row.value("run_name", ""));
  if (!is_value || row.value("error_occurred", false)) return;
  if (const auto frame = frame_of_row(parts))
    results.frames[*frame][parts[5]] = {row.value("real_time", 0.0), row.value("ask", 0.0)};
  const auto cell = cell_of_row(parts);
  if (!cell) return;
  results.cells[*cell][parts[4]] = {row.value("real_time", 0.0), row.value("p99", 0.0),
                                    row.value("move", 0.0), row.value("pairs", 0.0) != 0};
}

std::string machine_in(const json& context) {
  return context.value("cpu", "") + ", " + context.value("cores", "") + " cores, " +
         context.value("compiler", "") + ", commit " + context.value("commit", "");
}

// Google Benchmark writes the spread of counters that are zero as NaN, which JSON has not.
std::string with_zeros_for_nan(std::string_view text) {
  std::string result(text);
  for (const std::string_view nan : {": NaN", ": -NaN"}) {
    for (std::size_t at = result.find(nan); at != std::string::npos; at = result.find(nan, at))
      result.replace(at, nan.size(), ": 0");
  }
  return result;
}

}  // namespace

Status add_query_results(std::string_view text_of_file, QueryResults& results) {
  const Status refused = Status::bad_input("This is no JSON that Google Benchmark wrote.");
  const json file = json::parse(with_zeros_for_nan(text_of_file), nullptr, false);
  if (file.is_discarded() || !file.is_object() || !file.contains("benchmarks")) return refused;
  try {
    QueryResults more = results;
    if (more.machine.empty() && file.contains("context")) more.machine = machine_in(file["context"]);
    for (const json& row : file["benchmarks"]) take_row(row, more);
    results = std::move(more);
  } catch (const json::exception&) {
    return refused;
  }
  return {};
}

}  // namespace cellsweep::bench
