#include "report/experiment/curves.h"

namespace cellsweep::report {
namespace {

// Colours that also those tell apart who see few.
constexpr std::array kCurves = {
    Curve{"control", "control (x86)", "control", Part::frame, "#222222"},
    Curve{"cell-paper-spus", "cell-paper, SPU part only", "cell-paper", Part::spus, "#e69f00"},
    Curve{"cell-paper-longest-spu", "cell-paper, its longest SPU", "cell-paper", Part::longest_spu,
          "#c8b400"},
    Curve{"cell-paper", "cell-paper with updates", "cell-paper", Part::frame, "#d55e00"},
    Curve{"cell-paper-simulated", "cell-paper, simulated Cell", "cell-paper", Part::simulated_cell,
          "#8c564b"},
    Curve{"cell-brute", "cell-brute", "cell-brute", Part::frame, "#cc79a7"},
    Curve{"cell-resident", "cell-resident", "cell-resident", Part::frame, "#009e73"},
    Curve{"cell-resident-simulated", "cell-resident, simulated Cell", "cell-resident", Part::simulated_cell,
          "#00614a"},
    Curve{"stream", "stream", "stream", Part::frame, "#56b4e9"},
    Curve{"embree", "embree", "embree", Part::frame, "#0072b2"},
};

}  // namespace

std::span<const Curve> curve_table() {
  return kCurves;
}

}  // namespace cellsweep::report
