/// @file
/// Cycles of a program, and the numbers of the model, as text.
#ifndef SPU_EMU_TOOLS_CYCLE_TABLE_H
#define SPU_EMU_TOOLS_CYCLE_TABLE_H

#include <string>

#include "spu_emu/cycles.h"

namespace spu_emu {

/// Totals, stalls by cause, and a row a function, the most expensive first. Lines end in newlines.
std::string cycle_table(const CycleProfile& profile, double hertz);

/// A line for each parameter: name, value, meaning, source.
std::string cycle_parameter_table(const CycleParameters& parameters);

}  // namespace spu_emu

#endif
