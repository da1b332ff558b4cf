/// @file
/// Which SPEs get a debugger: by their settings, or by the environment of the process.
#ifndef SPU_EMU_SPE_DEBUGGER_CHOICE_H
#define SPU_EMU_SPE_DEBUGGER_CHOICE_H

#include <optional>

#include "spu_emu/emulation.h"

namespace spu_emu {

/// That of the settings; without one, that of SPU_EMU_DEBUG and SPU_EMU_DEBUG_COMMANDS when they mean the SPE
/// of this number. Throws std::invalid_argument when SPU_EMU_DEBUG is no number.
std::optional<DebuggerSettings> debugger_of(const EmulationSettings& settings, unsigned number);

}  // namespace spu_emu

#endif
