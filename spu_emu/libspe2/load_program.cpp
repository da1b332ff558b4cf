#include "libspe2/load_program.h"

#include <cerrno>

#include "isa/isa_program.h"
#include "libspe2/program_image.h"
#ifdef SPU_EMU_HOST_ENGINE
#include "host/host_program.h"
#endif

namespace spu_emu {

LoadResult load_program(Spe& spe, const ProgramImage& image) {
  switch (image_kind(image.bytes)) {
    case ImageKind::host_module:
#ifdef SPU_EMU_HOST_ENGINE
      return HostProgram::load(spe, image.bytes);
#else
      return {nullptr, ENOTSUP, "programs compiled for x86-64 do not run here"};
#endif
    case ImageKind::spu_elf:
      return isa::IsaProgram::load(spe, image);
    case ImageKind::none:
      break;
  }
  return {nullptr, EINVAL, "the image is no ELF file of an SPU program"};
}

}  // namespace spu_emu
