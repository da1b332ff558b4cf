# Installs the library with what find_package(cellsweep) and pkg-config need.
include(CMakePackageConfigHelpers)

set(cellsweep_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/cellsweep)

install(TARGETS cellsweep EXPORT cellsweep-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
                                                   LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/cellsweep DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT cellsweep-targets NAMESPACE cellsweep:: DESTINATION ${cellsweep_package_dir})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/cellsweep-config.cmake.in cellsweep-config.cmake
                              INSTALL_DESTINATION ${cellsweep_package_dir})
write_basic_package_version_file(cellsweep-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cellsweep-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/cellsweep-config-version.cmake DESTINATION ${cellsweep_package_dir})

# The library is static, so what it needs from the system is on every user's link line.
set(cellsweep_pc_libs " -pthread")
if(CELLSWEEP_CELL_ENGINES)
  set(cellsweep_pc_libs " -pthread -ldl")
endif()
if(CELLSWEEP_EMBREE)
  string(APPEND cellsweep_pc_libs " -lembree3")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/cellsweep.pc.in cellsweep.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cellsweep.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
