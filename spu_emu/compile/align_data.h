/// @file
/// The SPU's compiler gives every variable in memory 16 bytes of its own; DMA of programs relies on it.
#ifndef SPU_EMU_COMPILE_ALIGN_DATA_H
#define SPU_EMU_COMPILE_ALIGN_DATA_H

#include <string>
#include <string_view>

namespace spu_emu::compile {

/// `assembly` is what GCC or Clang wrote for x86-64. In the result every object lies at a multiple of 16
/// bytes at least. What the compiler merges, like strings without a name, stays as it is.
std::string align_data(std::string_view assembly);

}  // namespace spu_emu::compile

#endif
