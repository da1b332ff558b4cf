/// @file
/// elfutils' libdw, looked for when it is wanted.
#ifndef SPU_EMU_ISA_DEBUG_LIBDW_H
#define SPU_EMU_ISA_DEBUG_LIBDW_H

#include <dwarf.h>
#include <elfutils/libdw.h>

// The functions of libdw and libelf that are called here.
#define SPU_EMU_LIBDW_FUNCTIONS(EACH) \
  EACH(elf_version)                   \
  EACH(elf_memory)                    \
  EACH(elf_end)                       \
  EACH(dwarf_begin_elf)               \
  EACH(dwarf_end)                     \
  EACH(dwarf_nextcu)                  \
  EACH(dwarf_offdie)                  \
  EACH(dwarf_getsrclines)             \
  EACH(dwarf_onesrcline)              \
  EACH(dwarf_lineaddr)                \
  EACH(dwarf_lineno)                  \
  EACH(dwarf_linesrc)                 \
  EACH(dwarf_linebeginstatement)      \
  EACH(dwarf_lineendsequence)         \
  EACH(dwarf_child)                   \
  EACH(dwarf_siblingof)               \
  EACH(dwarf_tag)                     \
  EACH(dwarf_diename)                 \
  EACH(dwarf_dieoffset)               \
  EACH(dwarf_attr)                    \
  EACH(dwarf_attr_integrate)          \
  EACH(dwarf_formref_die)             \
  EACH(dwarf_formudata)               \
  EACH(dwarf_formsdata)               \
  EACH(dwarf_lowpc)                   \
  EACH(dwarf_highpc)                  \
  EACH(dwarf_getlocations)            \
  EACH(dwarf_peel_type)

namespace spu_emu::isa {

struct Libdw {
#define SPU_EMU_MEMBER(name) decltype(&::name) name;
  SPU_EMU_LIBDW_FUNCTIONS(SPU_EMU_MEMBER)
#undef SPU_EMU_MEMBER
};

}  // namespace spu_emu::isa

#endif
