# add_spu_program(name sources...
#   [INCLUDE_DIRECTORIES dirs...] [COMPILE_DEFINITIONS definitions...] [COMPILE_OPTIONS options...])
#
# Builds SPU sources (C++17 against the SDK's headers) for the host engine of spu_emu and makes the static library
# `name`, which defines `spe_program_handle_t name` with the program's image in it. Link it into the program that
# calls spe_program_load(context, &name), which declares `extern "C" spe_program_handle_t name;`.
function(add_spu_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "INCLUDE_DIRECTORIES;COMPILE_DEFINITIONS;COMPILE_OPTIONS")
  set(module ${name}_spu_module)
  set(program ${name}_spu_objects)

  # The program's own sources: main is renamed, for the module has no start-up code of its own.
  add_library(${program} OBJECT ${arg_UNPARSED_ARGUMENTS})
  target_compile_definitions(${program} PRIVATE main=spu_emu_program_main __SPU__=1 ${arg_COMPILE_DEFINITIONS})
  target_include_directories(${program} PRIVATE ${arg_INCLUDE_DIRECTORIES})
  target_compile_options(${program} PRIVATE ${arg_COMPILE_OPTIONS})

  add_library(${module} MODULE ${SPU_EMU_RUNTIME_DIR}/module.cpp $<TARGET_OBJECTS:${program}>)
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

  # The image object is compiled again whenever the module was linked again.
  set(image ${CMAKE_CURRENT_BINARY_DIR}/${name}_spu_image.cpp)
  add_custom_command(OUTPUT ${image}
    COMMAND ${CMAKE_COMMAND} -E copy ${SPU_EMU_RUNTIME_DIR}/image.cpp ${image}
    COMMAND ${CMAKE_COMMAND} -E touch ${image}
    DEPENDS ${module} ${SPU_EMU_RUNTIME_DIR}/image.cpp VERBATIM)
  add_library(${name} STATIC ${image})
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE spu_emu::headers)
  target_compile_definitions(${name} PRIVATE
    SPU_EMU_PROGRAM=${name} "SPU_EMU_IMAGE=\"$<TARGET_FILE:${module}>\"")
endfunction()
