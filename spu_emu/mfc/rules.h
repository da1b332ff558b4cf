/// @file
/// The MFC's rules for one command, checked before it is queued.
#ifndef SPU_EMU_MFC_RULES_H
#define SPU_EMU_MFC_RULES_H

#include "mfc/command.h"
#include "mfc/local_store.h"

namespace spu_emu {

/// Which of the two queues a command was written to.
enum class Issuer { spu, proxy };

/// Size, alignment, local store range and EA of one transfer of `size` bytes; `command` is what a fault
/// names. A size of 0 moves nothing and is legal. Returns the host address of the LS side. Throws Fault.
std::byte* check_transfer(const Command& command, std::uint32_t ls, std::uint64_t ea, std::uint32_t size,
                          LocalStoreView& store);

/// Command code, tag and what else is known when `command` is issued, list elements excepted. Returns the
/// host address of the LS side of a plain transfer, null for other commands. Throws Fault.
std::byte* check_command(const Command& command, Issuer issuer, LocalStoreView& store);

/// True for an EA that no program can own: below 64 KB, or beyond the 47 bits of a user address, where
/// pointers have 64.
constexpr bool is_bad_address(std::uint64_t ea, std::uint32_t size) {
  constexpr std::uint64_t kUserEnd = std::uint64_t{1} << (sizeof(void*) == 8 ? 47U : 32U);
  return ea < 0x10000U || ea > kUserEnd - size;
}

/// Between memory of different byte order only whole 32-bit words move. Throws Fault.
void check_words(const Command& command, std::uint32_t ls, std::uint64_t ea, std::uint32_t size,
                 const LocalStoreView& store);

/// Asks the system whether the command may access all pages of the range; a system call, so made in late
/// mode, and for real SPU code, whose errors must not end the process. Throws Fault.
void check_mapped(const Command& command, std::uint64_t ea, std::uint32_t size);

}  // namespace spu_emu

#endif
