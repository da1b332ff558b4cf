// When a DMA transfer moves its bytes: a setting of the emulation, not of the Cell.
#ifndef SPU_EMU_DMA_MODE_H
#define SPU_EMU_DMA_MODE_H

namespace spu_emu {

enum class DmaMode {
  /// Bytes move when the command is issued; every rule is checked.
  eager,
  /// Bytes move at the wait that covers the command, in a seeded order within what fences and barriers allow.
  late,
  /// Bytes move when the command is issued; no rules, no queue.
  unchecked
};

}  // namespace spu_emu

#endif
