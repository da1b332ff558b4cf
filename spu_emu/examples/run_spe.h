// What the examples share: the DMA mode from the command line, and running a context to its end.
#ifndef SPU_EMU_EXAMPLES_RUN_SPE_H
#define SPU_EMU_EXAMPLES_RUN_SPE_H

#include <libspe2.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "spu_emu/emulation.h"

/// Sets the process's DMA mode from the first argument: eager (also without one), late or unchecked.
inline void set_mode_from_arguments(int argc, char** argv) {
  spu_emu::EmulationSettings settings;
  const char* mode = argc > 1 ? argv[1] : "eager";
  if (std::strcmp(mode, "late") == 0) settings.dma_mode = spu_emu::DmaMode::late;
  if (std::strcmp(mode, "unchecked") == 0) settings.dma_mode = spu_emu::DmaMode::unchecked;
  spu_emu::set_default_settings(settings);
}

/// A context with the program in it; ends the process with a message when that fails.
inline spe_context_ptr_t load_spe(spe_program_handle_t& program) {
  spe_context_ptr_t spe = spe_context_create(SPE_EVENTS_ENABLE | SPE_MAP_PS, nullptr);
  if (spe == nullptr || spe_program_load(spe, &program) != 0) {
    std::perror(spe == nullptr ? "spe_context_create" : spu_emu::last_fault(spe).c_str());
    std::exit(EXIT_FAILURE);
  }
  return spe;
}

/// Runs the program on this thread; true if it exited with 0, else says why not.
inline bool run_spe(spe_context_ptr_t spe, void* argp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  if (spe_context_run(spe, &entry, 0, argp, nullptr, &stop) < 0) {
    std::fprintf(stderr, "%s\n", spu_emu::last_fault(spe).c_str());
    return false;
  }
  return stop.stop_reason == SPE_EXIT && stop.result.spe_exit_code == 0;
}

#endif
