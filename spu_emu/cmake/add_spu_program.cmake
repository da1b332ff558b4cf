# add_spu_program(name sources...
#   [INCLUDE_DIRECTORIES dirs...] [COMPILE_DEFINITIONS definitions...] [COMPILE_OPTIONS options...]
#   [ELF_OPTIONS options...] [HOST_ONLY] [CODE_RESERVE bytes] [DATA_RESERVE bytes] [STACK_RESERVE bytes])
#
# Builds SPU sources (.c and C++17, against the SDK's headers) for the host engine of spu_emu and makes the static library
# `name`, which defines `spe_program_handle_t name` with the program's image in it. Link it into the program that
# calls spe_program_load(context, &name), which declares `extern "C" spe_program_handle_t name;`.
#
# For a processor that the host engine is not for, `name` is the handle of the SPU ELF, and there is no other.
#
# Where the real compiler is (SPU_EMU_TOOLCHAIN_DIR), the same sources with the same options become NAME.elf, too; then
# the library also defines `spe_program_handle_t name_elf`, users of the library are compiled with SPU_EMU_HAS_ELF=1,
# and spu_emu_has_elf(name variable) is true. ELF_OPTIONS are for the real compiler only, HOST_ONLY is for sources that
# are not for a real SPU. The reserves are
# those that the host engine is told to count for the program, where they are not its defaults.
include(${CMAKE_CURRENT_LIST_DIR}/spu_elf.cmake)

# The library `name` gets an object that defines `handle` for the image in `file`; it is compiled again whenever `cause`
# was made again.
function(spu_emu_add_image name handle file cause)
  set(image ${CMAKE_CURRENT_BINARY_DIR}/${handle}_spu_image.cpp)
  add_custom_command(OUTPUT ${image}
    COMMAND ${CMAKE_COMMAND} -E copy ${SPU_EMU_RUNTIME_DIR}/image.cpp ${image}
    COMMAND ${CMAKE_COMMAND} -E touch ${image}
    DEPENDS ${cause} ${SPU_EMU_RUNTIME_DIR}/image.cpp VERBATIM)
  target_sources(${name} PRIVATE ${image})
  set_source_files_properties(${image} PROPERTIES
    COMPILE_DEFINITIONS "SPU_EMU_PROGRAM=${handle};SPU_EMU_IMAGE=\"${file}\"")
endfunction()

# The module by which the host engine runs a program, and the handle `name` of it.
function(spu_emu_add_module name)
  set(module ${name}_spu_module)
  set(program ${name}_spu_objects)

  # The program's own sources, translated on their way to the compiler. Those in C, too, are the C++ compiler's for
  # CMake, and the translator's to tell.
  add_library(${program} OBJECT ${ARGN})
  set_target_properties(${program} PROPERTIES CXX_COMPILER_LAUNCHER $<TARGET_FILE:spu_emu::compile>)
  add_dependencies(${program} spu_emu::compile)
  set(c_sources ${ARGN})
  list(FILTER c_sources INCLUDE REGEX "\\.c$")
  if(c_sources)
    set_source_files_properties(${c_sources} PROPERTIES LANGUAGE CXX)
  endif()
  # All are compiled again when the translator has changed.
  set(translator ${CMAKE_CURRENT_BINARY_DIR}/${name}.spu-emu-compile)
  add_custom_command(OUTPUT ${translator} COMMAND ${CMAKE_COMMAND} -E touch ${translator} DEPENDS spu_emu::compile
    COMMENT "" VERBATIM)
  set_property(SOURCE ${ARGN} APPEND PROPERTY OBJECT_DEPENDS ${translator})
  target_compile_definitions(${program} PRIVATE __SPU__=1)
  target_include_directories(${program} SYSTEM BEFORE PRIVATE ${SPU_EMU_INCLUDE_DIR}/spu_emu/libc)
  target_link_libraries(${program} PRIVATE ${name}_spu_settings)

  set(runtime ${SPU_EMU_RUNTIME_DIR}/module.cpp)
  if(c_sources)
    list(APPEND runtime ${SPU_EMU_RUNTIME_DIR}/c_intrinsics.cpp ${SPU_EMU_RUNTIME_DIR}/c_services.cpp)
  endif()
  add_library(${module} MODULE ${runtime} $<TARGET_OBJECTS:${program}>)
  foreach(target IN ITEMS ${program} ${module})
    set_target_properties(${target} PROPERTIES
      CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS ON POSITION_INDEPENDENT_CODE ON
      CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_link_libraries(${target} PRIVATE spu_emu::headers)
    target_compile_definitions(${target} PRIVATE $<$<BOOL:${SPU_EMU_PRECISE_FLOATS}>:SPU_EMU_PRECISE>)
    # SPU code runs rounding toward zero, and SDK code casts between vector and scalar pointers.
    target_compile_options(${target} PRIVATE -ffp-contract=off -frounding-math -fno-strict-aliasing -msse4.1
      $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  endforeach()
  set_target_properties(${module} PROPERTIES PREFIX "" SUFFIX ".spu.so" OUTPUT_NAME ${name})
  # Allocation and exit of the program are the SPU's, and no symbol of it may be shared between two loaded copies.
  target_link_options(${module} PRIVATE -Wl,-Bsymbolic
    -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free
    -Wl,--wrap=memalign,--wrap=aligned_alloc,--wrap=posix_memalign
    -Wl,--wrap=exit,--wrap=_exit,--wrap=atexit,--wrap=__cxa_atexit)
  if(c_sources)
    # Of the intrinsics only those that the program calls.
    target_compile_options(${module} PRIVATE -ffunction-sections -fdata-sections)
    target_link_options(${module} PRIVATE -Wl,--gc-sections)
  endif()
  spu_emu_add_image(${name} ${name} $<TARGET_FILE:${module}> ${module})
endfunction()

function(add_spu_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HOST_ONLY" "CODE_RESERVE;DATA_RESERVE;STACK_RESERVE"
    "INCLUDE_DIRECTORIES;COMPILE_DEFINITIONS;COMPILE_OPTIONS;ELF_OPTIONS")
  # What both compilers are told.
  add_library(${name}_spu_settings INTERFACE)
  target_compile_definitions(${name}_spu_settings INTERFACE ${arg_COMPILE_DEFINITIONS})
  target_include_directories(${name}_spu_settings INTERFACE ${arg_INCLUDE_DIRECTORIES})
  target_compile_options(${name}_spu_settings INTERFACE ${arg_COMPILE_OPTIONS})
  set_property(TARGET ${name}_spu_settings PROPERTY SPU_EMU_ELF_OPTIONS ${arg_ELF_OPTIONS})

  add_library(${name} STATIC)
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE spu_emu::headers)
  if(SPU_EMU_HOST_ENGINE)
    spu_emu_add_module(${name} ${arg_UNPARSED_ARGUMENTS})
  endif()

  spu_emu_find_toolchain(toolchain)
  if(NOT toolchain AND NOT SPU_EMU_HOST_ENGINE)
    message(FATAL_ERROR "${name}: for this processor SPU programs need the SPU compiler (spu_emu/toolchain/build)")
  endif()
  if(toolchain AND NOT arg_HOST_ONLY)
    spu_emu_add_elf(${name} ${toolchain} ${arg_UNPARSED_ARGUMENTS})
    if(SPU_EMU_TESTS)
      spu_emu_test_reserves(${name} ${toolchain} CODE_RESERVE ${arg_CODE_RESERVE} DATA_RESERVE ${arg_DATA_RESERVE}
        STACK_RESERVE ${arg_STACK_RESERVE})
    endif()
  endif()
endfunction()
