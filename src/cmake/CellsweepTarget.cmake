# How every target of the project is compiled.

# cellsweep_target(TARGET): C++20, our warnings, no fused multiply-add behind our back.
function(cellsweep_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
  if(CELLSWEEP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# cellsweep_library(TARGET): a library that users link: its headers, position-independent, nothing shown but what is
# marked with CELLSWEEP_API, a version in the name of a shared one.
function(cellsweep_library target)
  target_include_directories(
    ${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  string(REGEX REPLACE "^cellsweep_" "" name ${target})
  set_target_properties(
    ${target}
    PROPERTIES POSITION_INDEPENDENT_CODE ON
               CXX_VISIBILITY_PRESET hidden
               VISIBILITY_INLINES_HIDDEN ON
               VERSION ${PROJECT_VERSION}
               SOVERSION ${PROJECT_VERSION_MAJOR}
               EXPORT_NAME ${name})
  # What GCC marks as the only one of its name in a process (statics of the standard library's templates) would keep a
  # plugin that the library is linked into from being unloaded.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  cellsweep_fill_small_objects_by_stores(${target})
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    cellsweep_show_only_the_face(${target})
  endif()
endfunction()

# cellsweep_fill_small_objects_by_stores(TARGET): for x86, GCC fills and copies objects of more than some ninety bytes by
# one instruction that takes some thirty cycles before it begins, and a Status has 120: a tenth of what it takes to ask
# which bodies a point is in.
function(cellsweep_fill_small_objects_by_stores target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    set(strategy vector_loop:128:noalign,rep_8byte:8192:noalign,libcall:-1:noalign)
    target_compile_options(${target} PRIVATE -mmemset-strategy=${strategy} -mmemcpy-strategy=${strategy})
  endif()
endfunction()

# cellsweep_compile_together(TARGET [ROOM...]): the target's sources in each of these folders, or all of them when none is
# named, are one source for the compiler, which then reads a header that they share once. A source belongs to the first
# folder that it lies in; one that lies in none is compiled alone, and so are all with -DCMAKE_UNITY_BUILD=OFF.
function(cellsweep_compile_together target)
  if(DEFINED CMAKE_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  if(ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(room IN LISTS ARGN)
    set(inside ${sources})
    list(FILTER inside INCLUDE REGEX "^${room}/")
    list(FILTER sources EXCLUDE REGEX "^${room}/")
    string(REPLACE / _ group ${room})
    set_source_files_properties(${inside} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# cellsweep_show_only_the_face(TARGET): of a shared library, so that nobody links what is not meant for him.
function(cellsweep_show_only_the_face target)
  target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/src/cmake/exports.map
                      -Wl,--no-undefined)
  set_target_properties(${target} PROPERTIES LINK_DEPENDS ${PROJECT_SOURCE_DIR}/src/cmake/exports.map)
endfunction()

# cellsweep_quick_to_compile(TARGET): for targets whose own code is not what anybody waits for, above all the command line:
# little optimisation, in builds that have any.
function(cellsweep_quick_to_compile target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
endfunction()

# cellsweep_plain_when_sanitized(TARGET): for targets that run so little that a sanitized build need not optimise them:
# the sanitizers' checks are what clang's optimiser takes longest over.
function(cellsweep_plain_when_sanitized target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CELLSWEEP_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# cellsweep_quickest_to_compile(TARGET): both.
function(cellsweep_quickest_to_compile target)
  cellsweep_quick_to_compile(${target})
  cellsweep_plain_when_sanitized(${target})
endfunction()

# cellsweep_test_code(TARGET): for code of tests, which takes longer to compile than to run: no optimisation, but where an
# emulator runs it. What a failed test says of its place is the same wherever the project lies.
function(cellsweep_test_code target)
  target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
  if(CMAKE_CROSSCOMPILING)
    cellsweep_quick_to_compile(${target})
  else()
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()
