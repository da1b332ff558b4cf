/// @file
/// Reads what the loader must know of a program module, trusting none of its headers' numbers.
#ifndef SPU_EMU_HOST_ELF_IMAGE_H
#define SPU_EMU_HOST_ELF_IMAGE_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spu_emu {

/// Whether the bytes begin like a program module.
bool is_module(std::span<const std::byte> image);

/// Bytes that a module says it has: the end of its last table or segment. `known` are its first bytes, its
/// header at least; while its segment headers are not among them, the number is where those end.
std::uint64_t claimed_module_size(std::span<const std::byte> known);

/// What takes a module's constructors out of the dynamic linker's hands: in the copy that it loads, the
/// 64-bit words at these offsets must be zero. `init_array` says where the constructors are (an address
/// relative to the load address).
struct PreparedModule {
  std::vector<std::uint64_t> zero_words;
  std::uint64_t init_array = 0;
  std::uint64_t init_count = 0;
};

/// Nothing, with the reason in `error`, if `file` is no well-formed x86-64 shared object: every segment lies
/// inside the file, loaded ones follow one another, and the others lie inside of them. What the dynamic
/// linker finds in the segments (symbols, relocations) is not looked at: it is trusted as the code is.
std::optional<PreparedModule> prepare_module(std::span<const std::byte> file, std::string& error);

}  // namespace spu_emu

#endif
