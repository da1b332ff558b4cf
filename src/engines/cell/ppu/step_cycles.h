/// @file
/// Cycles of SPU programs by the steps of the document's chapter 4.2, told by the names of functions.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cellsweep/cell.h"
#include "engines/cell/emulation.h"

namespace cellsweep::cell {

/// Cycles of sort, change detection, compaction, overlap, DMA wait and the rest, in this order.
using StepCycles = std::array<std::uint64_t, 6>;

/// A function belongs to the step that it is listed for in step_cycles.cpp, or to the rest; its waits for DMA
/// always to that step.
StepCycles cycles_by_step(std::span<const FunctionCycles> functions);

/// What was counted between two moments, in microseconds. Counts that went back, as after a program was
/// loaded anew, began at 0.
SpeTime spe_time(const StepCycles& now, const StepCycles& before, double hertz);

}  // namespace cellsweep::cell
