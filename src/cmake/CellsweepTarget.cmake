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

# cellsweep_quick_to_compile(TARGET): for targets whose own code is not what anybody waits for, above all tests and
# the command line: little optimisation, in builds that have any.
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
