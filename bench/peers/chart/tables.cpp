#include "bench/peers/chart/tables.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/text.h"
#include "bench/measured/numbers.h"
#include "bench/peers/chart/ratios.h"
#include "bench/peers/peer_mode.h"
#include "report/units.h"

namespace cellsweep::bench {
namespace {

std::string time_of(double seconds) {
  return report::time_text(1e6 * seconds);
}

// Empty for files that do not have them.
std::string median_and_p99(const PeerTime& time) {
  return time.median > 0 ? time_of(time.median) + ", " + time_of(time.p99) : "";
}

std::string count_of(double count) {
  return report::count_text(static_cast<std::size_t>(count));
}

std::string summary_cell(const std::vector<CellRatio>& ratios) {
  const auto summary = summarise(ratios);
  if (!summary) return "";
  const CellRatio& smallest = summary->smallest;
  return text("**", two_digits(summary->mean), "**; ", two_digits(smallest.ratio()), " (",
              kPeerScenes[smallest.cell.scene], ", `", smallest.best, "`)");
}

std::size_t twice_as_long(const std::vector<CellRatio>& ratios) {
  return static_cast<std::size_t>(
      std::count_if(ratios.begin(), ratios.end(), [](const CellRatio& ratio) { return ratio.ratio() >= 2; }));
}

std::string inexact_lines(const PeerResults& results) {
  std::map<std::string, std::pair<double, std::size_t>> wrong;
  for (const auto& [cell, times] : results.cells) {
    for (const auto& [peer, time] : times) {
      if (time.exact()) continue;
      wrong[peer].first += time.missing + time.extra;
      ++wrong[peer].second;
    }
  }
  std::string lines;
  for (const auto& [peer, sum] : wrong) {
    lines += text("\n`", peer, "` was off by ", count_of(sum.first), " pairs in ", sum.second,
                  " cells, in which it does not count.\n");
  }
  return lines;
}

}  // namespace

std::string summary_markdown(const PeerResults& results) {
  const std::vector<CellRatio> all = ratios_of(results);
  std::map<std::size_t, std::map<std::size_t, std::vector<CellRatio>>> by_bodies;
  for (const CellRatio& ratio : all) by_bodies[ratio.cell.bodies][ratio.cell.mode].push_back(ratio);
  std::string table = "| bodies |";
  std::string rule = "|--:|";
  for (const PeerModeInfo& mode : kPeerModes) {
    table += text(" ", mode.title, " |");
    rule += "---|";
  }
  table += "\n" + rule + "\n";
  for (auto& [bodies, by_mode] : by_bodies) {
    table += text("| ", report::count_text(bodies), " |");
    for (std::size_t mode = 0; mode < kPeerModes.size(); ++mode) {
      table += text(" ", summary_cell(by_mode[mode]), " |");
    }
    table += "\n";
  }
  if (const auto summary = summarise(all)) {
    table += text("\nGeometric mean of all ", all.size(), " cells: ", two_digits(summary->mean), "; ",
                  twice_as_long(all), " of them are 2 or more.\n");
  }
  return table + inexact_lines(results);
}

std::string headline_markdown(const PeerResults& results) {
  const std::vector<CellRatio> all = ratios_of(results);
  const auto summary = summarise(all);
  if (!summary) return "";
  return text("In ", all.size(), " measured cases the fastest of the others took ", two_digits(summary->mean),
              " times as long as `stream` (geometric mean);\nin ", twice_as_long(all),
              " of them it took at least twice as long.\n");
}

std::string cells_markdown(const PeerResults& results) {
  std::string table =
      "| scene | bodies | mode | pairs | `stream` | median, 99 % | best other | its time | median, 99 % | "
      "ratio "
      "| `stream` / memory |\n"
      "|---|--:|---|--:|--:|--:|---|--:|--:|--:|--:|\n";
  for (const CellRatio& ratio : ratios_of(results)) {
    table += text("| ", kPeerScenes[ratio.cell.scene], " | ", report::count_text(ratio.cell.bodies), " | ",
                  kPeerModes[ratio.cell.mode].title, " | ", count_of(ratio.pairs), " | ",
                  time_of(ratio.stream.seconds), " | ", median_and_p99(ratio.stream), " | `", ratio.best,
                  "` | ", time_of(ratio.best_time.seconds), " | ", median_and_p99(ratio.best_time), " | ",
                  two_digits(ratio.ratio()), " | ",
                  ratio.memory > 0 ? two_digits(ratio.over_memory()) : std::string(), " |\n");
  }
  return table;
}

std::string tails_markdown(const PeerResults& results) {
  if (results.tails.empty()) return "";
  std::vector<Tail> tails = results.tails;
  std::sort(tails.begin(), tails.end(), [](const Tail& a, const Tail& b) { return a.cell < b.cell; });
  std::string table =
      "| | median | mean / median | 99th percentile / median | frames |\n|---|--:|--:|--:|--:|\n";
  for (const Tail& tail : tails) {
    table += text("| ", kPeerScenes[tail.cell.scene], ", ", report::count_text(tail.cell.bodies), ", ",
                  kPeerModes[tail.cell.mode].title, " | ", time_of(tail.median_seconds), " | ",
                  two_digits(tail.mean_over_median), " | ", two_digits(tail.p99_over_median), " | ",
                  count_of(tail.frames), " |\n");
  }
  return table;
}

std::string times_csv(const PeerResults& results) {
  std::string csv =
      text("# ", results.machine, "\n",
           "scene,bodies,mode,peer,seconds,median,p99,spread,pairs,missing,extra,over_stream\n");
  for (const auto& [cell, times] : results.cells) {
    const auto stream = times.find("stream");
    for (const auto& [peer, time] : times) {
      csv += text(kPeerScenes[cell.scene], ",", cell.bodies, ",", kPeerModes[cell.mode].name, ",", peer, ",",
                  time.seconds, ",", time.median, ",", time.p99, ",", time.spread, ",", time.pairs, ",",
                  time.missing, ",", time.extra, ",");
      if (stream != times.end()) csv += text(time.seconds / stream->second.seconds);
      csv += "\n";
    }
  }
  return csv;
}

}  // namespace cellsweep::bench
