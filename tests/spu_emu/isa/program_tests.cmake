# What is around the machine: ELF files, library calls, programs under libspe2 and alone.
spu_emu_test(spu_emu_isa_program_tests spu_emu.isa.
  encoding/assembler.cpp elf/elf_loader_test.cpp elf/program_store_test.cpp libc/library_calls_test.cpp
  libc/print_format_test.cpp program_test.cpp timing/cycle_profile_test.cpp)
spu_emu_test(spu_emu_isa_debugger_tests spu_emu.isa.
  encoding/assembler.cpp debug/debugger_test.cpp debug/source_lines_test.cpp debug/value_format_test.cpp
  debug/variables_test.cpp)
add_subdirectory(programs)
