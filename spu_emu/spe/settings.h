/// @file
/// The settings that the next context of this thread gets.
#ifndef SPU_EMU_SPE_SETTINGS_H
#define SPU_EMU_SPE_SETTINGS_H

#include "spu_emu/emulation.h"

namespace spu_emu {

/// Those of the innermost SettingsScope of this thread, else the process's default.
EmulationSettings current_settings();

}  // namespace spu_emu

#endif
