#include "app/ranks/rank_report.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "base/text.h"
#include "report/table.h"

namespace cellsweep::app {
namespace {

std::string fixed(double value, int digits) {
  std::array<char, 64> room;
  const int size = std::snprintf(room.data(), room.size(), "%.*f", digits, value);
  return {room.data(), static_cast<std::size_t>(size)};
}

std::string phase_table(const RankReport& report) {
  report::Table table({"ms a frame", "slowest rank", "CPU of all ranks"});
  double cpu = 0;
  for (const RankPhaseTimes& phase : report.phases) {
    if (phase.is_wait) continue;
    cpu += phase.cpu_milliseconds;
    table.add({phase.name, fixed(phase.milliseconds, 3), fixed(phase.cpu_milliseconds, 3)});
  }
  table.add({"all of these", "", fixed(cpu, 3)});
  for (const RankPhaseTimes& phase : report.phases) {
    if (phase.is_wait) table.add({"wait: " + phase.name, fixed(phase.milliseconds, 3), ""});
  }
  return table.text();
}

std::string rank_table(const RankReport& report) {
  report::Table table({"rank", "owned", "ghosts", "messages", "bytes", "CPU ms a frame"});
  for (std::size_t rank = 0; rank < report.ranks.size(); ++rank) {
    const RankRow& row = report.ranks[rank];
    table.add({text(rank), fixed(row.owned, 0), fixed(row.ghosts, 0), fixed(row.messages, 1),
               fixed(row.bytes, 0), fixed(row.cpu_milliseconds, 3)});
  }
  return table.text();
}

// A side that has no end is null.
nlohmann::ordered_json side(const Point& point) {
  nlohmann::ordered_json json;
  for (const float x : point)
    json.push_back(std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json());
  return json;
}

std::string checkpoint_words(const RankReport& report) {
  if (report.checkpoints == 0) return {};
  return text("Checkpoints: ", report.checkpoints, ", ", fixed(report.checkpoint_ms, 1), " ms each.\n\n");
}

std::string frame_table(const RankReport& report) {
  report::Table table({"frame", "pairs", "hash"});
  for (const RankFrame& frame : report.frames)
    table.add({text(frame.frame), text(frame.pairs), hash_text(frame.hash)});
  return table.text();
}

}  // namespace

std::string rank_tables(const std::string& source, const RankReport& report) {
  return text(source, ", ", report.bodies, " bodies, ", report.updates, " updates on ", report.ranks.size(),
              report.ranks.size() == 1 ? " rank\n\n" : " ranks\n\n", phase_table(report), "\n",
              rank_table(report), "\nTold a frame: ", fixed(report.moves, 1), " moves, ",
              fixed(report.enters, 1), " enters, ", fixed(report.leaves, 1), " leaves, ",
              fixed(report.adoptions, 1), " adoptions. Imbalance ", fixed(report.imbalance, 3), ", cut ",
              report.cuts, report.cuts == 1 ? " time.\n\n" : " times.\n\n", checkpoint_words(report),
              frame_table(report));
}

nlohmann::ordered_json rank_json(const std::string& source, const RankReport& report) {
  nlohmann::ordered_json json{{"source", source},
                              {"bodies", report.bodies},
                              {"first_frame", report.first_frame},
                              {"updates", report.updates}};
  for (const RankPhaseTimes& phase : report.phases) {
    json["phases"].push_back({{"name", phase.name},
                              {"wait", phase.is_wait},
                              {"slowest_rank_ms", phase.milliseconds},
                              {"cpu_ms_of_all_ranks", phase.cpu_milliseconds}});
  }
  for (std::size_t rank = 0; rank < report.ranks.size(); ++rank) {
    const RankRow& row = report.ranks[rank];
    json["ranks"].push_back({{"region", {side(report.regions[rank].min), side(report.regions[rank].max)}},
                             {"owned", row.owned},
                             {"ghosts", row.ghosts},
                             {"messages", row.messages},
                             {"bytes", row.bytes},
                             {"cpu_ms", row.cpu_milliseconds}});
  }
  json["moves"] = report.moves;
  json["enters"] = report.enters;
  json["leaves"] = report.leaves;
  json["adoptions"] = report.adoptions;
  json["imbalance"] = report.imbalance;
  json["cuts"] = report.cuts;
  if (report.checkpoints > 0)
    json["checkpoints"] = {{"written", report.checkpoints}, {"ms_each", report.checkpoint_ms}};
  for (const RankFrame& frame : report.frames)
    json["frames"].push_back(
        {{"frame", frame.frame}, {"pairs", frame.pairs}, {"hash", hash_text(frame.hash)}});
  return json;
}

std::string rank_timeline(const RankReport& report) {
  std::string events;
  for (std::size_t rank = 0; rank < report.ranks.size(); ++rank) {
    events += text(R"({"name":"thread_name","ph":"M","pid":0,"tid":)", rank, R"(,"args":{"name":"rank )",
                   rank, "\"}},\n");
  }
  events += report.timeline;
  events.resize(events.size() - 2);  // the last comma
  return "[\n" + events + "\n]\n";
}

}  // namespace cellsweep::app
