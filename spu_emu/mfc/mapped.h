/// @file
/// Asks the system whether memory is there, without touching it.
#ifndef SPU_EMU_MFC_MAPPED_H
#define SPU_EMU_MFC_MAPPED_H

#include <cstdint>

namespace spu_emu {

enum class Access { read, write };

/// Whether this process may access all pages of [first, first + size). On Linux before 5.14 the answer only
/// tells whether pages are mapped; an emulator of user processes may say yes whatever the page. A system
/// call.
bool is_mapped(std::uint64_t first, std::uint64_t size, Access access);

}  // namespace spu_emu

#endif
