#include "bench/queries/table/query_tables.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/measured/numbers.h"
#include "bench/queries/query_world.h"
#include "bench/queries/question.h"
#include "report/units.h"

namespace cellsweep::bench {
namespace {

constexpr std::string_view kOwn = "stream";

bool is_ours(const std::string& name) {
  return name.starts_with(kOwn);
}

std::string name_of(const QueryCell& cell) {
  return std::string(kQueryWorlds[cell.world]) + " | " + report::count_text(cell.bodies) + " | " +
         std::string(kQuestionKinds[cell.kind].title);
}

std::string time_of(const std::map<std::string, QueryTime>& times, const std::string& name) {
  const auto found = times.find(name);
  return found == times.end() ? "" : decimals_text(found->second.ns, 0);
}

/// The ratios of one place of the summary.
struct Ratios {
  double sum_of_logs = 0;
  double count = 0;
  const QueryRatio* smallest = nullptr;

  void add(const QueryRatio& ratio) {
    sum_of_logs += std::log(ratio.ratio());
    ++count;
    if (smallest == nullptr || ratio.ratio() < smallest->ratio()) smallest = &ratio;
  }
  std::string text() const {
    if (smallest == nullptr) return "";
    return "**" + two_digits(std::exp(sum_of_logs / count)) + "**; " + two_digits(smallest->ratio()) + " (" +
           std::string(kQueryWorlds[smallest->cell.world]) + ", `" + smallest->best + "`)";
  }
};

}  // namespace

std::vector<QueryRatio> query_ratios(const QueryResults& results) {
  std::vector<QueryRatio> ratios;
  for (const auto& [cell, times] : results.cells) {
    const auto own = times.find(std::string(kOwn));
    if (own == times.end()) continue;
    QueryRatio ratio{cell, own->second, "", {}};
    for (const auto& [name, time] : times) {
      if (is_ours(name) || (!ratio.best.empty() && ratio.best_time.ns <= time.ns)) continue;
      ratio.best = name;
      ratio.best_time = time;
    }
    if (!ratio.best.empty()) ratios.push_back(ratio);
  }
  return ratios;
}

std::string query_summary(const QueryResults& results) {
  const std::vector<QueryRatio> ratios = query_ratios(results);
  std::set<std::size_t> sizes;
  for (const QueryRatio& ratio : ratios) sizes.insert(ratio.cell.bodies);
  std::string text = "| question |";
  std::string rule = "|---|";
  for (const std::size_t bodies : sizes) {
    text += " " + report::count_text(bodies) + " bodies |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (std::size_t kind = 0; kind < kQuestionKinds.size(); ++kind) {
    text += "| " + std::string(kQuestionKinds[kind].title) + " |";
    for (const std::size_t bodies : sizes) {
      Ratios here;
      for (const QueryRatio& ratio : ratios) {
        if (!ratio.cell.is_moved && ratio.cell.kind == kind && ratio.cell.bodies == bodies) here.add(ratio);
      }
      text += " " + here.text() + " |";
    }
    text += "\n";
  }
  return text;
}

std::string query_cells(const QueryResults& results) {
  std::string text =
      "| world | bodies | question | `stream` | p99 | in batches | all threads | best other | ns | p99 | "
      "ratio | others |\n|---|--:|---|--:|--:|--:|--:|---|--:|--:|--:|---|\n";
  for (const QueryRatio& ratio : query_ratios(results)) {
    if (ratio.cell.is_moved) continue;
    const auto& times = results.cells.at(ratio.cell);
    text += "| " + name_of(ratio.cell) + " | " + decimals_text(ratio.own.ns, 0) + " | " +
            decimals_text(ratio.own.p99, 0) + " | " + time_of(times, "stream_batch_1") + " | " +
            time_of(times, "stream_batch") + " | `" + ratio.best + "` | " +
            decimals_text(ratio.best_time.ns, 0) + " | " + decimals_text(ratio.best_time.p99, 0) + " | " +
            two_digits(ratio.ratio()) + " |";
    for (const auto& [name, time] : times) {
      if (!is_ours(name) && name != ratio.best) text += " `" + name + "` " + decimals_text(time.ns, 0);
    }
    text += " |\n";
  }
  return text;
}

std::string frame_cells(const QueryResults& results) {
  std::string text =
      "| world | bodies | of them move | `stream`, µs a frame | a ray, ns | how many times as long; a ray, "
      "ns |\n"
      "|---|--:|--:|--:|--:|---|\n";
  for (const auto& [cell, times] : results.frames) {
    const auto own = times.find("stream");
    if (own == times.end()) continue;
    text += "| " + std::string(kQueryWorlds[cell.world]) + " | " + report::count_text(cell.bodies) + " | " +
            std::to_string(cell.percent) + " % | " + decimals_text(own->second.us, 0) + " | " +
            decimals_text(own->second.ask_ns, 0) + " |";
    std::string_view before = " ";
    for (const auto& [name, time] : times) {
      if (is_ours(name)) continue;
      text += before;
      text += "`" + name + "` **" + two_digits(ratio_in_turns(time.turns, own->second.turns)) + "**; " +
              decimals_text(time.ask_ns, 0);
      before = ", ";
    }
    text += " |\n";
  }
  return text;
}

std::string moved_cells(const QueryResults& results) {
  std::string text =
      "| world | bodies | question | who | tree anew, ms | question, ns |\n|---|--:|---|---|--:|--:|\n";
  for (const auto& [cell, times] : results.cells) {
    if (!cell.is_moved) continue;
    for (const auto& [name, time] : times) {
      text += "| " + name_of(cell) + " | `" + name + "` | " +
              (time.moves_for_pairs ? "0 (pairs: " + decimals_text(time.move_ms, 1) + ")"
                                    : decimals_text(time.move_ms, 1)) +
              " | " + decimals_text(time.ns, 0) + " |\n";
    }
  }
  return text;
}

}  // namespace cellsweep::bench
