# Installs headers, library, program runtime and the CMake package spu_emu.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/spu_emu)
install(TARGETS spu_emu spu_emu_headers EXPORT spu_emu_targets)
install(EXPORT spu_emu_targets NAMESPACE spu_emu:: DESTINATION ${package_dir})
install(DIRECTORY include/ sdk/include/common/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/spu_emu)
install(DIRECTORY runtime/ DESTINATION ${CMAKE_INSTALL_DATADIR}/spu_emu/runtime)
install(FILES cmake/add_spu_program.cmake cmake/spu_elf.cmake cmake/spu_elf_report.cmake DESTINATION ${package_dir})

set(SPU_EMU_INSTALLED_RUNTIME ${CMAKE_INSTALL_DATADIR}/spu_emu/runtime)
configure_package_config_file(cmake/spu_emu-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/spu_emu-config.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS SPU_EMU_INSTALLED_RUNTIME)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/spu_emu-config-version.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/spu_emu-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/spu_emu-config-version.cmake DESTINATION ${package_dir})
