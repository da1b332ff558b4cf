# Debian's packages of a build with -DCELLSWEEP_DEBIAN=ON (preset debian): ninja package makes them in the build folder.
#   libcellsweep1       the shared library
#   libcellsweep-dev    headers, what CMake and pkg-config need, and the parts world, cell and embree as static libraries
#   cellsweep           the command, its pages for man, its completion in bash
#   python3-cellsweep   the module for Python
#   spu-emu-dev         the emulation of the Cell's small processors, for programs of its own

set(packages libcellsweep1 libcellsweep-dev cellsweep python3-cellsweep spu-emu-dev)
set(components_of_libcellsweep1 runtime)
set(components_of_libcellsweep-dev core world cell embree)
set(components_of_cellsweep command)
set(components_of_python3-cellsweep python)
set(components_of_spu-emu-dev spu_emu)

# Pages for man, of the command and each of its subcommands and of spu-run, from their --help.
find_program(CELLSWEEP_HELP2MAN help2man REQUIRED)
set(man_pages ${CMAKE_CURRENT_BINARY_DIR}/man)
add_custom_command(
  OUTPUT ${man_pages}/done
  COMMAND ${PROJECT_SOURCE_DIR}/src/packages/make_man_pages ${CELLSWEEP_HELP2MAN} ${man_pages} $<TARGET_FILE:cellsweep_app>
          $<TARGET_FILE:spu_run>
  DEPENDS cellsweep_app spu_run ${PROJECT_SOURCE_DIR}/src/packages/make_man_pages
  VERBATIM)
add_custom_target(cellsweep_man_pages ALL DEPENDS ${man_pages}/done)
install(DIRECTORY ${man_pages}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT command PATTERN spu-run.1.gz EXCLUDE)
install(FILES ${man_pages}/man1/spu-run.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT spu_emu)
install(FILES ${PROJECT_SOURCE_DIR}/src/packages/completion.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME cellsweep
        COMPONENT command)

# What every package of Debian's has.
set(CELLSWEEP_MAINTAINER "The founders of cellsweep <cellsweep@example.org>" CACHE STRING "Who makes the packages")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${PROJECT_SOURCE_DIR}/src/packages/changelog.in changelog @ONLY)
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
execute_process(COMMAND gzip -9nc ${CMAKE_CURRENT_BINARY_DIR}/changelog OUTPUT_FILE ${changelog}
                COMMAND_ERROR_IS_FATAL ANY)
foreach(package IN LISTS packages)
  list(GET components_of_${package} 0 component)
  install(
    FILES ${PROJECT_SOURCE_DIR}/src/packages/copyright ${changelog}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${CELLSWEEP_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package says its own
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_CURRENT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_COMPONENTS_ALL "")
foreach(package IN LISTS packages)
  string(TOUPPER ${package} group)
  set(CPACK_DEBIAN_${group}_PACKAGE_NAME ${package})
  foreach(component IN LISTS components_of_${package})
    string(TOUPPER ${component} upper)
    set(CPACK_COMPONENT_${upper}_GROUP ${package})
    list(APPEND CPACK_COMPONENTS_ALL ${component})
  endforeach()
endforeach()

# package_says(PACKAGE SECTION SUMMARY TEXT...): what a person reads of it; one line of text an argument.
macro(package_says package section summary)
  string(TOUPPER ${package} group)
  set(CPACK_DEBIAN_${group}_PACKAGE_SECTION ${section})
  string(JOIN "\n" CPACK_DEBIAN_${group}_DESCRIPTION "${summary}" ${ARGN})
endmacro()

set(about "cellsweep finds which axis-aligned boxes in a moving world overlap: exactly,"
          "every frame, with the pairs that began and ended. It answers questions"
          "about regions, rays and neighbours.")
package_says(libcellsweep1 libs "exact, parallel broadphase collision detection" ${about} "This package has the shared library.")
package_says(
  libcellsweep-dev libdevel "exact, parallel broadphase collision detection (development)" ${about}
  "This package has the headers for C++ and C, and the library's parts that" "need others, as static libraries.")
package_says(cellsweep science "measure and watch exact broadphase collision detection" ${about}
             "This package has the command, which simulates, verifies, replays, records" "and draws worlds.")
package_says(python3-cellsweep python "exact, parallel broadphase collision detection (Python)" ${about}
             "This package has the module for Python, which takes and returns NumPy's" "arrays.")
package_says(
  spu-emu-dev libdevel "run programs for the Cell's small processors (development)"
  "spu_emu compiles programs written for the SPUs of the Cell processor against" "an emulation of them: local stores of 256 KB, DMA with the hardware's rules,"
  "mailboxes, libspe2. The command spu-run runs programs in their machine code.")
set(python_minor ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
math(EXPR python_next "${Python_VERSION_MINOR} + 1")
set(python_next ${Python_VERSION_MAJOR}.${python_next})
set(this_version "libcellsweep1 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LIBCELLSWEEP-DEV_PACKAGE_DEPENDS "${this_version}")
set(CPACK_DEBIAN_CELLSWEEP_PACKAGE_DEPENDS "${this_version}")
set(CPACK_DEBIAN_LIBCELLSWEEP-DEV_PACKAGE_SUGGESTS "libeigen3-dev, libzip-dev, libembree-dev, spu-emu-dev")
set(CPACK_DEBIAN_SPU-EMU-DEV_PACKAGE_SUGGESTS "libdw1")
set(CPACK_DEBIAN_PYTHON3-CELLSWEEP_PACKAGE_DEPENDS "${this_version}, python3 (>= ${python_minor}), python3 (<< ${python_next}), python3-numpy")

# What else links the library, and a word to the loader that it is there.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs "libcellsweep ${PROJECT_VERSION_MAJOR} ${this_version}\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBCELLSWEEP1_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/shlibs ${CMAKE_CURRENT_BINARY_DIR}/triggers)
set(CPACK_DEBIAN_LIBCELLSWEEP-DEV_PACKAGE_SHLIBDEPS OFF)
include(CPack)
