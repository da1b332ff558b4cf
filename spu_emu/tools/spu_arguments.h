/// @file
/// The command line of an SPU program that runs alone, in the form its start-up code expects.
#ifndef SPU_EMU_TOOLS_SPU_ARGUMENTS_H
#define SPU_EMU_TOOLS_SPU_ARGUMENTS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tools/guest_memory.h"

namespace spu_emu {

/// How a program's start-up code takes its arguments.
enum class MainKind {
  /// main(argc, argv): it fetches an argument region by DMA and puts its stack below it (linked with
  /// -mstdmain).
  standard,
  /// main(speid, argp, envp).
  spe
};

/// Tells the kind by the first instructions of a well-formed SPU ELF file: only the first one issues a DMA
/// command.
MainKind main_kind(std::span<const std::byte> elf_file);

/// Registers r3 to r5 for SPE_RUN_USER_REGS, and the memory they refer to, which the program reads by DMA and
/// may write.
///
/// standard: argc; and the region of argv pointers and texts that goes to the top of the local store. spe:
/// number 1; argp is the address of the arguments, each ended by a NUL; envp is their size, a multiple of 16.
/// Behind the arguments the memory at argp is the program's to use.
class SpuArguments {
 public:
  /// Throws std::length_error when the arguments are more than one DMA command moves.
  SpuArguments(MainKind kind, const std::vector<std::string>& arguments, std::uint32_t local_store_size);

  std::array<unsigned int, 12>& registers() { return registers_; }

 private:
  std::uint64_t keep(std::span<const std::byte> bytes);

  GuestMemory memory_;
  std::array<unsigned int, 12> registers_{};
};

}  // namespace spu_emu

#endif
