# Builds spu_emu with what this project's options ask for: its examples and tests with ours, its benchmarks with ours.
set(SPU_EMU_TESTS ${CELLSWEEP_BUILD_TESTS} CACHE BOOL "Build the tests of spu_emu")
set(SPU_EMU_EXAMPLES ${CELLSWEEP_BUILD_TESTS} CACHE BOOL "Build the examples of spu_emu")
set(SPU_EMU_BENCHMARKS ${CELLSWEEP_BUILD_BENCHMARKS} CACHE BOOL "Build the benchmarks of spu_emu")
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME spu_emu)
add_subdirectory(${PROJECT_SOURCE_DIR}/spu_emu ${PROJECT_BINARY_DIR}/spu_emu)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME command)
