/// @file
/// How a program image becomes a program of an SPE: the engines have loaders, and who knows the engines
/// chooses.
#ifndef SPU_EMU_SPE_PROGRAM_LOADER_H
#define SPU_EMU_SPE_PROGRAM_LOADER_H

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "spe/program.h"

namespace spu_emu {

class Spe;

/// What came of loading: a program, or an errno value and the reason.
struct LoadResult {
  std::unique_ptr<Program> program;
  int error = 0;
  std::string reason;
};

/// The bytes of an image and none beyond them. `toe`, where it is not null, is what the host side has for the
/// image's section .toe: the effective addresses that the program knows as _EAR_ and a name.
struct ProgramImage {
  std::span<const std::byte> bytes;
  const void* toe = nullptr;
};

/// Loads an image. The program refers to `spe`, which outlives it. Throws std::bad_alloc.
using ProgramLoader = LoadResult (*)(Spe& spe, const ProgramImage& image);

}  // namespace spu_emu

#endif
