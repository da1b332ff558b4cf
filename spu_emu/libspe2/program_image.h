/// @file
/// Program images in memory: of what kind they are, and how many of the bytes are theirs.
#ifndef SPU_EMU_LIBSPE2_PROGRAM_IMAGE_H
#define SPU_EMU_LIBSPE2_PROGRAM_IMAGE_H

#include <libspe2-types.h>

#include <cstddef>
#include <span>
#include <string>

namespace spu_emu {

enum class ImageKind { none, host_module, spu_elf };

/// What the first bytes of an image say it is.
ImageKind image_kind(std::span<const std::byte> image);

/// No image has more bytes than this.
inline constexpr std::size_t kLargestImage = std::size_t{256} << 20U;

/// Opens the program in a file, for spe_image_close(). Null with errno, as spe_image_open() says.
spe_program_handle_t* open_image(const char* filename);
/// 0, or an errno value; EINVAL for a handle that open_image() did not give or that is closed.
int close_image(spe_program_handle_t* program);

/// An image, or the reason why there is none.
struct ImageBytes {
  std::span<const std::byte> bytes;
  std::string error;
};

/// The bytes of a handle's image. Of an opened one that is the file. Of another one, as the linker puts them
/// into programs, nobody says the size but the image's own headers; these are believed as far as this process
/// has memory to read there, and up to kLargestImage. So a header that lies may pass off bytes behind an
/// image as its own, but leads to no memory that cannot be read.
ImageBytes image_bytes(const spe_program_handle_t& program);

}  // namespace spu_emu

#endif
