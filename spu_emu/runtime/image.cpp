// Embeds an SPU program's image and defines its handle; the build says which.
#include <libspe2-types.h>

asm(".section .rodata.spu_image, \"a\", @progbits\n"
    ".balign 128\n"
    ".local spu_emu_image_of_this_file\n"
    "spu_emu_image_of_this_file:\n"
    ".incbin \"" SPU_EMU_IMAGE
    "\"\n"
    ".balign 64\n"
    ".text\n");

extern "C" {
extern char spu_emu_image_of_this_file[];
extern spe_program_handle_t SPU_EMU_PROGRAM;
spe_program_handle_t SPU_EMU_PROGRAM = {sizeof(spe_program_handle_t), spu_emu_image_of_this_file, nullptr};
}
