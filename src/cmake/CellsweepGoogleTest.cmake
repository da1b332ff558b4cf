# GoogleTest for another processor than the build machine's, from its sources, which Debian has, too.
set(CELLSWEEP_GOOGLETEST_SOURCE /usr/src/googletest CACHE PATH "Sources of GoogleTest")
if(NOT EXISTS ${CELLSWEEP_GOOGLETEST_SOURCE}/CMakeLists.txt)
  message(FATAL_ERROR "cellsweep's tests need GoogleTest's sources. On Debian: apt-get install googletest")
endif()
set(INSTALL_GTEST OFF)
add_subdirectory(${CELLSWEEP_GOOGLETEST_SOURCE} ${CMAKE_BINARY_DIR}/googletest EXCLUDE_FROM_ALL SYSTEM)
