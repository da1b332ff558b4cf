#include "engines/cell/spu_elf.h"

#include "engines/cell/spu_programs.h"

#if defined(SPU_EMU_HAS_ELF)
extern "C" spe_program_handle_t cell_paper_spu_elf, cell_brute_spu_elf, cell_resident_spu_elf,
    cell_stream_spu_elf;
#endif

namespace cellsweep::cell {

bool has_only_spu_elf() {
#if defined(CELLSWEEP_SPU_PROGRAMS_ARE_ELF)
  return true;
#else
  return false;
#endif
}

bool has_spu_elf() {
#if defined(SPU_EMU_HAS_ELF)
  return true;
#else
  return has_only_spu_elf();
#endif
}

spe_program_handle_t* spu_elf_of([[maybe_unused]] spe_program_handle_t& program) {
#if defined(CELLSWEEP_SPU_PROGRAMS_ARE_ELF)
  return &program;
#elif defined(SPU_EMU_HAS_ELF)
  if (&program == &cell_paper_spu) return &cell_paper_spu_elf;
  if (&program == &cell_brute_spu) return &cell_brute_spu_elf;
  if (&program == &cell_resident_spu) return &cell_resident_spu_elf;
  if (&program == &cell_stream_spu) return &cell_stream_spu_elf;
#endif
  return nullptr;
}

}  // namespace cellsweep::cell
