// What a program module asks of the emulation that loaded it: one table of functions, handed over at its
// entry.
#ifndef SPU_EMU_SERVICES_H
#define SPU_EMU_SERVICES_H

#include <cstddef>

#include "spu_emu/source_line.h"

namespace spu_emu {

/// Calls of one SPE, to be made only from its own SPU program; `spe` goes back as each function's first
/// argument. None returns an error: a broken rule leaves the program for good and is reported by
/// spe_context_run.
struct HostServices {
  void* spe;
  unsigned int (*read_channel)(void* spe, unsigned int channel, SourceLine where);
  void (*write_channel)(void* spe, unsigned int channel, unsigned int value, SourceLine where);
  unsigned int (*channel_count)(void* spe, unsigned int channel, SourceLine where);
  /// Issues one MFC command; `ls` is a pointer of the program (or an LS address as a number), sizes in bytes.
  /// `file` and `line` are a SourceLine's, apart: as a struct they would be read back from the stack wider
  /// than they were written, which stalls the processor for as long as a short transfer takes.
  void (*dma)(void* spe, const volatile void* ls, unsigned long long ea, unsigned int size, unsigned int tag,
              unsigned int command, const char* file, int line);
  /// Stop and signal with a 14-bit code; comes back only when the context is run again.
  void (*stop)(void* spe, unsigned int code, SourceLine where);
  /// Library call 0x2100-0x21ff: the handler sees `data` as an LS address below `opcode` in the top byte.
  int (*call_host)(void* spe, unsigned int code, unsigned int opcode, void* data, SourceLine where);
  void (*halt)(void* spe, SourceLine where);
  void* (*allocate)(void* spe, std::size_t size, std::size_t alignment);
  void* (*reallocate)(void* spe, void* block, std::size_t size);
  void (*release)(void* spe, void* block);
  /// Lowest tag of `count` neighbouring free ones, now reserved; 0xffffffff when there are none.
  unsigned int (*reserve_tags)(void* spe, unsigned int count);
  /// 0 when all the tags were reserved and are now free, else 0xffffffff and nothing changes.
  unsigned int (*release_tags)(void* spe, unsigned int tag, unsigned int count);
};

}  // namespace spu_emu

/// The table of the SPE that runs this module; set before main, never null inside an SPU program.
extern "C" __attribute__((visibility("hidden"))) const spu_emu::HostServices* spu_emu_services;

#endif
