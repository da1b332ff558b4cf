#include "bench/bullet/table/bullet_tables.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bench/measured/numbers.h"
#include "report/units.h"

namespace cellsweep::bench {
namespace {

constexpr std::string_view kTree = "bullet_dbvt";
constexpr std::string_view kExact = "stream_1";
constexpr std::string_view kMargin = "stream_1_margin";

/// What was measured of one world and number of bodies, by who did it.
struct Cell {
  std::string world;
  std::size_t bodies = 0;
  std::map<std::string, const MeasuredRow*, std::less<>> rows;

  const MeasuredRow* row(std::string_view name) const {
    const auto found = rows.find(name);
    return found == rows.end() ? nullptr : found->second;
  }
};

/// Of the rows bullet/WORLD/N/NAME that have a counter, in their order.
std::vector<Cell> cells_with(const MeasuredRows& measured, const std::string& counter) {
  std::vector<Cell> cells;
  for (const MeasuredRow& row : measured.rows) {
    if (row.parts.size() < 4 || row.parts[0] != "bullet" || !row.counters.contains(counter)) continue;
    const auto bodies = number_in(row.parts[2]);
    if (!bodies) continue;
    auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& known) {
      return known.world == row.parts[1] && known.bodies == *bodies;
    });
    if (cell == cells.end()) cell = cells.insert(cells.end(), Cell{row.parts[1], *bodies, {}});
    cell->rows[row.parts[3]] = &row;
  }
  return cells;
}

std::string mean_and_p99(const MeasuredRow* row) {
  return row == nullptr ? ""
                        : text(two_digits(1e6 * row->seconds), " (", two_digits(row->counter("p99")), ")");
}

std::string ratio(const MeasuredRow* of, const MeasuredRow* to) {
  return of == nullptr || to == nullptr ? "" : two_digits(ratio_in_turns(of->turns, to->turns));
}

std::string whole_steps(const Cell& cell) {
  std::string all;
  for (const std::string_view name : {kTree, kExact, kMargin}) {
    const MeasuredRow* row = cell.row(name);
    if (row != nullptr)
      all += text(all.empty() ? "" : ", ", report::factor_text(row->counter("frame") / 1e3));
  }
  return all;
}

/// How far the turns of rows lie apart: of the row in the middle, and of the one where they do most.
std::string spread_line(const std::vector<Cell>& cells) {
  std::vector<std::pair<double, std::string>> spreads;
  for (const Cell& cell : cells) {
    for (const auto& [name, row] : cell.rows)
      spreads.emplace_back(100 * row->spread,
                           text(report::count_text(cell.bodies), " in ", cell.world, ", ", name));
  }
  if (spreads.empty()) return "";
  std::sort(spreads.begin(), spreads.end());
  const auto& [most, where] = spreads.back();
  return text("\nStandard deviation of a row's turns over their mean: ",
              decimals_text(spreads[spreads.size() / 2].first, 0), " % in the middle, ",
              decimals_text(most, 0), " % at most (", where, ").\n");
}

}  // namespace

std::string bullet_frames(const MeasuredRows& measured) {
  std::string table =
      "| world | bodies | Bullet's tree | `stream`, exact | ratio | with a margin | ratio | whole step, ms "
      "|\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|\n";
  const std::vector<Cell> cells = cells_with(measured, "frame");
  for (const Cell& cell : cells) {
    const MeasuredRow* tree = cell.row(kTree);
    const MeasuredRow* exact = cell.row(kExact);
    const MeasuredRow* margin = cell.row(kMargin);
    table += text("| ", cell.world, " | ", report::count_text(cell.bodies), " | ", mean_and_p99(tree), " | ",
                  mean_and_p99(exact), " | ", ratio(tree, exact), " | ", mean_and_p99(margin), " | ",
                  ratio(tree, margin), " | ", whole_steps(cell), " |\n");
  }
  return table + spread_line(cells);
}

std::string bullet_questions(const MeasuredRows& measured) {
  std::string table =
      "| question | Bullet's tree | met | `stream` | met | ratio |\n|---|--:|--:|--:|--:|--:|\n";
  for (const Cell& cell : cells_with(measured, "met")) {
    const MeasuredRow* tree = cell.row(kTree);
    const MeasuredRow* own = cell.row(kExact);
    if (tree == nullptr || own == nullptr) continue;
    table += text("| ", cell.world, " | ", two_digits(1e6 * tree->seconds), " | ",
                  two_digits(tree->counter("met")), " | ", two_digits(1e6 * own->seconds), " | ",
                  two_digits(own->counter("met")), " | ", ratio(tree, own), " |\n");
  }
  return table;
}

}  // namespace cellsweep::bench
