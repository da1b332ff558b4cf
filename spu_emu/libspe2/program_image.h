/// @file
/// Tells what kind of program an image in memory is, and how long.
#ifndef SPU_EMU_LIBSPE2_PROGRAM_IMAGE_H
#define SPU_EMU_LIBSPE2_PROGRAM_IMAGE_H

#include <cstddef>

namespace spu_emu {

enum class ImageKind { none, host_module, spu_elf };

/// What the first 64 bytes at `image` say it is; the caller vouches for those bytes.
ImageKind image_kind(const void* image);

/// Bytes of the ELF file at `image`, which is of one of the two kinds: up to the end of its header tables;
/// linkers put that of the sections last. Of an SPU ELF file without sections, up to the end of its segments.
std::size_t image_size(const void* image);

}  // namespace spu_emu

#endif
