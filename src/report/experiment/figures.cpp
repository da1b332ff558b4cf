#include "report/experiment/figures.h"

#include <array>

#include "base/text.h"

namespace cellsweep::report {
namespace {

constexpr std::array kFigures = {
    Figure{"initial", "All boxes new: the initial sort", "Figure 5.2",
           "The first frame, in which every box is new and the sorted lists have to be made.",
           "time of the first frame", Measure::initial, "", false},
    Figure{"static", "Nothing moves", "Figure 5.3",
           "A frame after the initial sort in which no box moves: median of all such frames.",
           "median frame time", Measure::still, "", false},
    Figure{"dynamic-spus", "10 % move: the SPUs alone against the x86 version", "Figure 5.4",
           "The longest frame while one box in ten moves; of the Cell version only what its SPUs do.",
           "longest frame time", Measure::longest,
           "control cell-paper-spus cell-paper-longest-spu cell-paper-simulated", false},
    Figure{"dynamic", "10 % move: longest frame with all that belongs to it", "Figure 5.5",
           "The longest frame while one box in ten moves, the updates of the pair manager included.",
           "longest frame time", Measure::longest, "", true},
    Figure{"dynamic-median", "10 % move: the usual frame", "",
           "The median frame while one box in ten moves: what a frame takes when nothing else disturbs it.",
           "median frame time", Measure::median, "", true},
};

bool shows(const Figure& figure, const Curve& curve) {
  if (!figure.curves.empty()) {
    return text(" ", figure.curves, " ").find(text(" ", curve.id, " ")) != std::string::npos;
  }
  return curve.part == Part::frame || curve.part == Part::simulated_cell ||
         (figure.with_spu_part && curve.part == Part::spus);
}

}  // namespace

std::span<const Figure> figure_table() {
  return kFigures;
}

std::vector<const CurveResult*> curves_of(const Figure& figure, const ExperimentResults& results) {
  std::vector<const CurveResult*> curves;
  for (const CurveResult& result : results.curves) {
    if (shows(figure, result.curve)) curves.push_back(&result);
  }
  return curves;
}

}  // namespace cellsweep::report
