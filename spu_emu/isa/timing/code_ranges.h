/// @file
/// Which parts of a program belong to which function, by its symbols.
#ifndef SPU_EMU_ISA_TIMING_CODE_RANGES_H
#define SPU_EMU_ISA_TIMING_CODE_RANGES_H

#include <vector>

#include "isa/elf/elf_loader.h"
#include "isa/timing/cycle_model.h"

namespace spu_emu::isa {

/// Of symbols by rising address, with demangled names. A symbol without a size reaches to the next one, or to
/// `image_end`: what a program makes up on its stack has no name. Of several at one address the first counts.
std::vector<CodeRange> code_ranges(const std::vector<ElfSymbol>& symbols, std::uint32_t image_end);

}  // namespace spu_emu::isa

#endif
