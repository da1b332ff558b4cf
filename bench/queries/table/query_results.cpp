#include "bench/queries/table/query_results.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "bench/measured/measured_rows.h"
#include "bench/queries/query_world.h"
#include "bench/queries/question.h"

namespace cellsweep::bench {
namespace {

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
  const auto bodies = number_in(parts[2]);
  const auto percent = number_in(parts[4]);
  if (!world || !bodies || !percent) return std::nullopt;
  return FrameCell{*bodies, *percent, *world};
}

/// From queries/WORLD/N/KIND/NAME or moved/WORLD/N/KIND/NAME.
std::optional<QueryCell> cell_of_row(const std::vector<std::string>& parts) {
  if (parts.size() < 5 || (parts[0] != "queries" && parts[0] != "moved")) return std::nullopt;
  const auto world = world_of(parts[1]);
  const auto bodies = number_in(parts[2]);
  const auto kind = std::find_if(kQuestionKinds.begin(), kQuestionKinds.end(),
                                 [&](const QuestionKindInfo& info) { return info.name == parts[3]; });
  if (!world || !bodies || kind == kQuestionKinds.end()) return std::nullopt;
  return QueryCell{parts[0] == "moved", static_cast<std::size_t>(kind - kQuestionKinds.begin()), *bodies,
                   *world};
}

void take_row(const MeasuredRow& row, QueryResults& results) {
  if (const auto frame = frame_of_row(row.parts))
    results.frames[*frame][row.parts[5]] = {1e6 * row.seconds, row.counter("ask"), row.turns};
  if (const auto cell = cell_of_row(row.parts))
    results.cells[*cell][row.parts[4]] = {1e9 * row.seconds, row.counter("p99"), row.counter("move"),
                                          row.counter("pairs") != 0, row.turns};
}

}  // namespace

Status add_query_results(std::string_view text_of_file, QueryResults& results) {
  const Result<MeasuredRows> measured = read_measured_rows(text_of_file);
  if (!measured) return measured.status();
  if (results.machine.empty()) results.machine = measured->machine;
  for (const MeasuredRow& row : measured->rows) take_row(row, results);
  return {};
}

}  // namespace cellsweep::bench
