/// @file
/// Reads what the loader must know of a program module, trusting none of its numbers.
#ifndef SPU_EMU_HOST_ELF_IMAGE_H
#define SPU_EMU_HOST_ELF_IMAGE_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace spu_emu {

/// Whether the bytes at `image` begin like a program module; the caller vouches for 64 of them.
bool is_module(const std::byte* image);

/// Bytes of the module at `image`, which is one: up to the end of its section headers, which linkers put
/// last.
std::size_t module_size(const std::byte* image);

/// A module's file with its constructors taken out of the dynamic linker's hands: `init_array` says where
/// they are (addresses relative to the load address).
struct PreparedModule {
  std::vector<std::byte> file;
  std::uint64_t init_array = 0;
  std::uint64_t init_count = 0;
};

/// Nothing if `file` is no well-formed x86-64 shared object.
std::optional<PreparedModule> prepare_module(std::span<const std::byte> file);

}  // namespace spu_emu

#endif
