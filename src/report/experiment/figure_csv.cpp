#include "report/experiment/figure_csv.h"

#include <algorithm>

#include "base/text.h"
#include "report/units.h"

namespace cellsweep::report {
namespace {

std::string_view part_name(Part part) {
  switch (part) {
    case Part::spus:
      return "spus";
    case Part::longest_spu:
      return "longest spu";
    case Part::simulated_cell:
      return "simulated cell";
    default:
      return "frame";
  }
}

// What strangers' machines call themselves must not end the line.
std::string on_one_line(std::string value) {
  for (char& c : value) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return value;
}

std::string comment(const std::string& name, const std::string& value) {
  return "# " + name + ": " + on_one_line(value) + "\n";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> settings_of(const ExperimentSettings& settings) {
  std::string sizes;
  for (const std::size_t bodies : settings.bodies) sizes += (sizes.empty() ? "" : ", ") + count_text(bodies);
  return {
      {"scene", "paper"},
      {"boxes", sizes},
      {"moving", text(100 * settings.moving, " %")},
      {"frames", text(count_text(settings.frames), " with nothing moving, then as many with some moving")},
      {"simulated Cell",
       settings.simulated_frames == 0
           ? "none"
           : text("the SPE that takes longest, at 3.2 GHz by the cycle model, SPE threads already "
                  "running; ",
                  count_text(std::min(settings.frames, settings.simulated_frames)),
                  " frames of each kind, once")},
      {"repetitions", text(settings.repetitions, ", all engines in turns")},
      {"seed", text(settings.seed)}};
}

std::string figure_csv(const Figure& figure, const ExperimentResults& results) {
  std::string csv =
      comment("figure", std::string(figure.title)) + comment("shows", std::string(figure.caption));
  for (const auto& [name, value] : results.context) csv += comment(name, value);
  for (const auto& [name, value] : settings_of(results.settings)) csv += comment(name, value);
  csv += comment("units", "times in microseconds; median, lowest and highest of the repetitions");
  csv += "figure,curve,engine,part,bodies,median_us,lowest_us,highest_us,repetitions\n";
  for (const CurveResult* result : curves_of(figure, results)) {
    for (const auto& [bodies, times] : result->points) {
      const Spread& time = times[figure.measure];
      csv += text(figure.id, ",", result->curve.id, ",", result->curve.engine, ",",
                  part_name(result->curve.part), ",", bodies, ",", time.median, ",", time.lowest, ",",
                  time.highest, ",", time.repetitions, "\n");
    }
  }
  return csv;
}

}  // namespace cellsweep::report
