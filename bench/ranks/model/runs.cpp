#include "ranks/model/runs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/text.h"

namespace cellsweep::ranks_bench {
namespace {

std::string rounded(double value, int digits) {
  char digits_of[64];
  std::snprintf(digits_of, sizeof digits_of, "%.*f", digits, value);
  return digits_of;
}

// 1,234,567
std::string grouped(double value) {
  std::string digits = rounded(value, 0);
  for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, ",");
  return digits;
}

std::string percent_off(double foretold, double measured) {
  const double off = 100 * (foretold / measured - 1);
  return text(off < 0 ? "" : "+", rounded(off, 1), " %");
}

constexpr int kForetoldRanks[] = {1, 10, 100, 1000, 10000};
constexpr double kBodiesARank = 1e6;

}  // namespace

Result<std::vector<MeasuredRun>> read_runs(const std::string& json) {
  std::vector<MeasuredRun> runs;
  try {
    for (const auto& run : nlohmann::json::parse(json)) {
      runs.push_back({run.at("bodies"), run.at("ranks"), run.at("ghosts"), run.at("bytes"),
                      run.at("messages"), run.at("enters"), run.at("ranks_cpu_ms").at("mean")});
    }
  } catch (const nlohmann::json::exception& error) {
    return Status::bad_input(text("That is no list of runs over ranks: ", error.what(), "."));
  }
  if (runs.empty()) return Status::bad_input("There is no run in it.");
  return runs;
}

Costs fit(const std::vector<MeasuredRun>& runs) {
  double bb = 0;
  double bg = 0;
  double gg = 0;
  double bt = 0;
  double gt = 0;
  double enters = 0;
  double ghosts = 0;
  for (const MeasuredRun& run : runs) {
    bb += run.bodies * run.bodies;
    bg += run.bodies * run.ghosts;
    gg += run.ghosts * run.ghosts;
    bt += run.bodies * run.cpu_ms * 1e6;
    gt += run.ghosts * run.cpu_ms * 1e6;
    enters += run.enters;
    ghosts += run.ghosts;
  }
  const double determinant = bb * gg - bg * bg;
  Costs costs;
  costs.ns_a_body = (bt * gg - gt * bg) / determinant;
  costs.ns_a_ghost = (gt * bb - bt * bg) / determinant;
  costs.enters_a_ghost = enters / ghosts;
  return costs;
}

std::string measured_markdown(const std::vector<MeasuredRun>& runs, const Costs& costs) {
  std::string table =
      "| bodies | ranks | ghosts | foretold | bytes a frame | foretold | messages | foretold |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const MeasuredRun& run : runs) {
    const Forecast forecast = foretell(run.bodies, run.ranks, costs);
    table += text("| ", grouped(run.bodies), " | ", run.ranks, " | ", grouped(run.ghosts), " | ",
                  percent_off(forecast.ghosts, run.ghosts), " | ", grouped(run.bytes), " | ",
                  percent_off(forecast.bytes, run.bytes), " | ", rounded(run.messages, 1), " | ",
                  rounded(forecast.messages, 1), " |\n");
  }
  return table;
}

std::string forecast_markdown(const Costs& costs) {
  std::string table =
      "| ranks | bodies | ghosts a rank | KB a rank | messages a rank | computing ms | network ms |\n"
      "|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const int ranks : kForetoldRanks) {
    const Forecast forecast = foretell(kBodiesARank * ranks, ranks, costs);
    table +=
        text("| ", grouped(ranks), " | ", grouped(forecast.bodies), " | ", grouped(forecast.ghosts / ranks),
             " | ", rounded(forecast.bytes / ranks / 1e3, 0), " | ", rounded(forecast.messages / ranks, 1),
             " | ", rounded(forecast.compute_ms, 0), " | ", rounded(forecast.network_ms, 2), " |\n");
  }
  return table;
}

double largest_error(const std::vector<MeasuredRun>& runs, const Costs& costs) {
  double largest = 0;
  for (const MeasuredRun& run : runs) {
    const Forecast forecast = foretell(run.bodies, run.ranks, costs);
    largest = std::max(
        {largest, std::fabs(forecast.ghosts / run.ghosts - 1), std::fabs(forecast.bytes / run.bytes - 1)});
  }
  return largest;
}

std::string chart_script(const std::vector<MeasuredRun>& runs, const Costs& costs) {
  std::string script =
      "set terminal pngcairo size 960,560 font 'DejaVu Sans,11'\n"
      "set logscale xy\nset key top left\nset grid lc rgb '#dddddd'\n"
      "set xlabel 'ranks'\nset ylabel 'ghosts of all ranks'\nset format y '10^{%L}'\nset format x '%g'\n"
      "set xrange [1.6:12000]\n";
  const auto list = [&](const char* name, const std::string& points) {
    script += text("$", name, " << EOD\n", points, "EOD\n");
  };
  for (const double bodies : {1e5, 1e6}) {
    std::string measured;
    std::string foretold;
    for (const MeasuredRun& run : runs) {
      if (run.bodies == bodies) measured += text(run.ranks, " ", run.ghosts, "\n");
    }
    for (int ranks = 2; ranks <= 64; ranks *= 2)
      foretold += text(ranks, " ", foretell(bodies, ranks, costs).ghosts, "\n");
    list(bodies < 1e6 ? "measured_few" : "measured_many", measured);
    list(bodies < 1e6 ? "foretold_few" : "foretold_many", foretold);
  }
  std::string growing;
  for (int ranks = 2; ranks <= 8192; ranks *= 2)
    growing += text(ranks, " ", foretell(kBodiesARank * ranks, ranks, costs).ghosts, "\n");
  list("growing", growing);
  script +=
      "plot $foretold_few with lines lw 2 lc rgb '#2c6fbb' title '100,000 bodies, foretold', \\\n"
      "  $measured_few with points pt 7 ps 1.2 lc rgb '#2c6fbb' title 'measured', \\\n"
      "  $foretold_many with lines lw 2 lc rgb '#d7191c' title '1,000,000 bodies, foretold', \\\n"
      "  $measured_many with points pt 7 ps 1.2 lc rgb '#d7191c' title 'measured', \\\n"
      "  $growing with lines lw 2 dt (9,4) lc rgb '#444444' title '1,000,000 bodies a rank, foretold'\n";
  return script;
}

}  // namespace cellsweep::ranks_bench
