# What a Cell blade gets: the command on the machine's SPEs and the command on emulated ones, with the C library that
# they were linked with, as a tarball that unpacks anywhere.

find_library(CELLSWEEP_LIBSPE2 spe2)
if(CELLSWEEP_LIBSPE2)
  add_library(cellsweep_libspe2 UNKNOWN IMPORTED)
  set_target_properties(cellsweep_libspe2 PROPERTIES IMPORTED_LOCATION ${CELLSWEEP_LIBSPE2})
else()
  # Nothing but the real library's name and functions, to link with: what comes out runs where the real one is.
  file(STRINGS ${PROJECT_SOURCE_DIR}/tests/spu_emu/data/SDK_NAMES.tsv rows REGEX "^libspe2\\.h\t")
  list(TRANSFORM rows REPLACE "^libspe2\\.h\t([a-z0-9_]+).*" "extern \"C\" void \\1() {}")
  list(JOIN rows "\n" interface)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/libspe2_interface.cpp CONTENT "${interface}\n" @ONLY)
  add_library(cellsweep_libspe2 SHARED ${CMAKE_CURRENT_BINARY_DIR}/libspe2_interface.cpp)
  set_target_properties(cellsweep_libspe2 PROPERTIES OUTPUT_NAME spe2 SOVERSION 2)
endif()

# The same objects as the emulated command's, but for what gives them their SPEs: of all libraries, and of spu_emu none.
get_property(programs GLOBAL PROPERTY CELLSWEEP_SPU_PROGRAMS)
list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
add_executable(
  cellsweep_on_libspe2
  engines/cell/libspe2_spes.cpp $<TARGET_OBJECTS:cellsweep_app> $<TARGET_OBJECTS:cellsweep_view>
  $<TARGET_OBJECTS:cellsweep_report> $<TARGET_OBJECTS:cellsweep_world> $<TARGET_OBJECTS:cellsweep>
  $<FILTER:$<TARGET_OBJECTS:cellsweep_cell>,EXCLUDE,spu_emu_emulation> ${programs})
cellsweep_target(cellsweep_on_libspe2)
target_include_directories(cellsweep_on_libspe2 PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
target_include_directories(cellsweep_on_libspe2 SYSTEM PRIVATE ${PROJECT_SOURCE_DIR}/spu_emu/include)
target_link_libraries(cellsweep_on_libspe2 PRIVATE cellsweep_libspe2 Threads::Threads)
set_target_properties(cellsweep_on_libspe2 PROPERTIES SKIP_BUILD_RPATH ON)
target_link_options(cellsweep_on_libspe2 PRIVATE -Wl,--no-undefined)

# The C library goes with the commands, because a blade's is older; each is started through its own loader.
set(blade_dir lib/cellsweep)
foreach(pair IN ITEMS cellsweep:cellsweep_on_libspe2 cellsweep-emulated:cellsweep_app)
  string(REGEX MATCH "(.*):(.*)" pair ${pair})
  set(CELLSWEEP_BLADE_COMMAND ${CMAKE_MATCH_1})
  set(target ${CMAKE_MATCH_2})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/blade_command.in blade/${CELLSWEEP_BLADE_COMMAND} @ONLY)
  install(PROGRAMS ${CMAKE_CURRENT_BINARY_DIR}/blade/${CELLSWEEP_BLADE_COMMAND} DESTINATION bin COMPONENT blade)
  install(PROGRAMS $<TARGET_FILE:${target}> RENAME ${CELLSWEEP_BLADE_COMMAND} DESTINATION ${blade_dir} COMPONENT blade)
endforeach()
foreach(library IN ITEMS ld64.so.1 libc.so.6 libm.so.6)
  find_file(CELLSWEEP_${library} ${library} PATHS /lib /lib64 REQUIRED NO_CACHE)
  file(REAL_PATH ${CELLSWEEP_${library}} library_file)
  install(PROGRAMS ${library_file} RENAME ${library} DESTINATION ${blade_dir} COMPONENT blade)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/bench/scenes DESTINATION share/cellsweep COMPONENT blade)

set(CPACK_GENERATOR TGZ)
set(CPACK_PACKAGE_FILE_NAME cellsweep-${PROJECT_VERSION}-cell)
set(CPACK_INSTALL_CMAKE_PROJECTS ${PROJECT_BINARY_DIR} cellsweep blade /)
include(CPack)
