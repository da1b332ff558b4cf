/// @file
/// Finds out whether memory is there by touching it, at the price of an instruction for each page.
#ifndef SPU_EMU_MFC_TOUCH_H
#define SPU_EMU_MFC_TOUCH_H

#include <cstdint>

#include "mfc/mapped.h"

namespace spu_emu {

/// Whether all pages of [first, first + size) can be read or written; nothing is changed. A page that is not
/// there raises SIGSEGV or SIGBUS inside, so somebody has to have said guard_touches(true); as long as nobody
/// has, the system is asked, which takes many times as long.
bool can_touch(std::uint64_t first, std::uint64_t size, Access access);

/// Who handles those signals: from now on the handler lets touches go on.
void guard_touches(bool guarded);

/// For the handler: where to go on after a signal at this instruction if it is that of a touch, else 0.
std::uintptr_t touch_goes_on_at(std::uintptr_t instruction);

}  // namespace spu_emu

#endif
