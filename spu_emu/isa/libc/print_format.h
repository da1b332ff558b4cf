/// @file
/// The printf family for an SPU program: its format and arguments lie in the local store.
#ifndef SPU_EMU_ISA_LIBC_PRINT_FORMAT_H
#define SPU_EMU_ISA_LIBC_PRINT_FORMAT_H

#include <optional>
#include <string>

#include "isa/libc/store_bytes.h"

namespace spu_emu::isa {

/// What printf would print. An unknown conversion stands for itself. Nothing, when it is longer than
/// kLongestPrint. Throws BadAddress.
std::optional<std::string> print_format(StoreBytes& store, const std::string& format,
                                        ArgumentList& arguments);

inline constexpr std::size_t kLongestPrint = std::size_t{1} << 24U;

}  // namespace spu_emu::isa

#endif
