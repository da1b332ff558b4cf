/// @file
/// The printf family for an SPU program: its format and arguments lie in the local store.
#ifndef SPU_EMU_ISA_LIBC_PRINT_FORMAT_H
#define SPU_EMU_ISA_LIBC_PRINT_FORMAT_H

#include <string>

#include "isa/libc/store_bytes.h"

namespace spu_emu::isa {

/// A text, or an errno value and no text.
struct PrintResult {
  std::string text;
  int error = 0;
};

/// What printf would print; wide characters become UTF-8. An unknown conversion stands for itself. EOVERFLOW
/// for more than kLongestPrint bytes, EILSEQ for a wide character that is none. Throws BadAddress.
PrintResult print_format(StoreBytes& store, const std::string& format, ArgumentList& arguments);

inline constexpr std::size_t kLongestPrint = std::size_t{1} << 24U;

}  // namespace spu_emu::isa

#endif
