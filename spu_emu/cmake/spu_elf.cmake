# SPU programs as real SPU ELF files, where the toolchain of toolchain/build is there; add_spu_program uses this.
set(SPU_EMU_TOOLCHAIN_DIR "" CACHE PATH "Folder of the SPU compiler, or OFF; empty: where toolchain/build puts it")

# spu_emu_find_toolchain(OUT): the folder of a complete toolchain, or nothing.
function(spu_emu_find_toolchain out)
  set(folder "${SPU_EMU_TOOLCHAIN_DIR}")
  if(folder STREQUAL "")
    set(folder "$ENV{SPU_EMU_TOOLCHAIN_DIR}")
  endif()
  if(folder STREQUAL "")
    set(cache "$ENV{XDG_CACHE_HOME}")
    if(cache STREQUAL "")
      set(cache "$ENV{HOME}/.cache")
    endif()
    set(folder ${cache}/cellsweep/spu-elf)
  endif()
  if(NOT EXISTS ${folder}/complete)
    set(folder "")
  endif()
  set(${out} "${folder}" PARENT_SCOPE)
endfunction()

# A line for the end of a configuration: whether there is a toolchain.
function(spu_emu_describe_toolchain out)
  spu_emu_find_toolchain(folder)
  if(folder)
    set(${out} "found    spu-elf-g++ in ${folder}: SPU programs as ELF" PARENT_SCOPE)
  else()
    set(${out} "missing  spu-elf-g++: SPU programs as ELF (spu_emu/toolchain/build)" PARENT_SCOPE)
  endif()
endfunction()

# spu_emu_has_elf(NAME OUT): whether add_spu_program(NAME) made the handle NAME_elf, too.
function(spu_emu_has_elf name out)
  get_property(programs GLOBAL PROPERTY SPU_EMU_ELF_PROGRAMS)
  if(name IN_LIST programs)
    set(${out} TRUE PARENT_SCOPE)
  else()
    set(${out} FALSE PARENT_SCOPE)
  endif()
endfunction()

# spu_emu_compile_elf(NAME TOOLCHAIN OUT SOURCES...): rules for the objects of one program, with the settings of the
# interface library NAME_spu_settings.
function(spu_emu_compile_elf name toolchain out)
  set(flags -O2 -fno-strict-aliasing -ffp-contract=off -ffunction-sections -fdata-sections
    $<$<NOT:$<CONFIG:Debug>>:-DNDEBUG>)
  set(options $<TARGET_PROPERTY:${name}_spu_settings,INTERFACE_COMPILE_OPTIONS>)
  set(elf_options $<TARGET_PROPERTY:${name}_spu_settings,SPU_EMU_ELF_OPTIONS>)
  set(definitions $<TARGET_PROPERTY:${name}_spu_settings,INTERFACE_COMPILE_DEFINITIONS>)
  set(includes $<TARGET_PROPERTY:${name}_spu_settings,INTERFACE_INCLUDE_DIRECTORIES>)
  set(objects "")
  foreach(source IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER ${source} object)
    set(object ${name}.elf.dir/${object}.o)
    cmake_path(ABSOLUTE_PATH source)
    # The options of the program come later, and so may name another language standard.
    set(compiler spu-elf-g++ -std=gnu++17 -fno-exceptions -fno-rtti)
    if(source MATCHES "[.]c$")
      set(compiler spu-elf-gcc -std=gnu11 -fcommon -fgnu89-inline)
    endif()
    add_custom_command(OUTPUT ${object} DEPFILE ${object}.d DEPENDS ${source} ${toolchain}/complete
      COMMAND ${toolchain}/bin/${compiler} ${flags} "${options}" "${elf_options}"
        "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" "$<$<BOOL:${includes}>:-I$<JOIN:${includes},;-I>>" -MMD -MF ${object}.d -MT ${object} -c ${source}
        -o ${object}
      WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMENT "Building SPU object ${object}"
      COMMAND_EXPAND_LISTS VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.elf.dir)
  set(${out} ${objects} PARENT_SCOPE)
endfunction()

# The target spu_sizes prints what every program takes and leaves of the local store.
function(spu_emu_add_to_sizes name toolchain)
  set_property(GLOBAL APPEND PROPERTY SPU_EMU_ELF_PROGRAMS ${name})
  if(NOT TARGET spu_sizes)
    add_custom_target(spu_sizes
      COMMAND ${CMAKE_COMMAND} -DTOOLCHAIN=${toolchain} "-DPROGRAMS=$<TARGET_PROPERTY:spu_sizes,SPU_EMU_ELF_FILES>"
        -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/spu_elf_report.cmake
      COMMENT "Bytes of the local store's 256 KB" VERBATIM)
  endif()
  set_property(TARGET spu_sizes APPEND PROPERTY SPU_EMU_ELF_FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.elf)
  add_dependencies(spu_sizes ${name}_spu_elf)
endfunction()

# A test of this project: the host engine's reserves are not smaller than what the real program takes.
function(spu_emu_test_reserves name toolchain)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "CODE_RESERVE;DATA_RESERVE;STACK_RESERVE" "")
  add_test(NAME spu_elf_fits_the_reserves.${name}
    COMMAND ${CMAKE_COMMAND} -DTOOLCHAIN=${toolchain} -DPROGRAMS=${CMAKE_CURRENT_BINARY_DIR}/${name}.elf
      -DCODE_RESERVE=${arg_CODE_RESERVE} -DDATA_RESERVE=${arg_DATA_RESERVE} -DSTACK_RESERVE=${arg_STACK_RESERVE}
      -DDEFAULTS=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../include/spu_emu/emulation.h
      -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/spu_elf_report.cmake)
endfunction()

# spu_emu_add_elf(NAME TOOLCHAIN SOURCES...): NAME.elf, and the handle NAME_elf in the library NAME.
function(spu_emu_add_elf name toolchain)
  spu_emu_compile_elf(${name} ${toolchain} objects ${ARGN})
  # The linker writes the output's name into the file, so it is a name without a folder. Its analysis of the stack
  # goes to a file of its own, for the reports.
  add_custom_command(OUTPUT ${name}.elf BYPRODUCTS ${name}.elf.stack DEPENDS ${objects}
    COMMAND ${toolchain}/bin/spu-elf-g++ -Wl,--gc-sections,--stack-analysis -o ${name}.elf ${objects}
      > ${name}.elf.stack
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMENT "Linking SPU program ${name}.elf" VERBATIM)
  set(elf ${CMAKE_CURRENT_BINARY_DIR}/${name}.elf)
  add_custom_target(${name}_spu_elf DEPENDS ${elf})
  add_dependencies(${name} ${name}_spu_elf)
  # When the toolchain goes away, so do the rules that need it.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${toolchain}/complete)
  if(SPU_EMU_HOST_ENGINE)
    spu_emu_add_image(${name} ${name}_elf ${elf} ${elf})
    target_compile_definitions(${name} INTERFACE SPU_EMU_HAS_ELF=1)
  else()
    spu_emu_add_image(${name} ${name} ${elf} ${elf})
  endif()
  spu_emu_add_to_sizes(${name} ${toolchain})
endfunction()
