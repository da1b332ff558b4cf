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
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:${CELLSWEEP_QUICK_OPTIMISATION}>)
endfunction()

# What clang's optimiser takes longest over is the checks that the sanitizers put in.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CELLSWEEP_SANITIZE)
  set(CELLSWEEP_QUICK_OPTIMISATION -O0)
else()
  set(CELLSWEEP_QUICK_OPTIMISATION -O1)
endif()
