# Installs the libraries with what find_package(cellsweep) and pkg-config need, each as a component of its own.
include(CMakePackageConfigHelpers)

set(cellsweep_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/cellsweep)
set(cellsweep_pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
# From the folder of the .pc files to the prefix, so that an installed tree may be moved.
file(RELATIVE_PATH CELLSWEEP_PC_PREFIX /${cellsweep_pc_dir} /)
string(REGEX REPLACE "/$" "" CELLSWEEP_PC_PREFIX "${CELLSWEEP_PC_PREFIX}")

# cellsweep_install_library(COMPONENT TARGET REQUIRES PRIVATE_LIBS HEADERS...): `REQUIRES` are other .pc files,
# `PRIVATE_LIBS` what a static library needs from the system; headers are files and folders of include/cellsweep.
function(cellsweep_install_library component target requires libs)
  install(
    TARGETS ${target}
    EXPORT cellsweep-${component}-targets
    COMPONENT ${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT ${component})
  install(
    EXPORT cellsweep-${component}-targets
    NAMESPACE cellsweep::
    DESTINATION ${cellsweep_package_dir}
    COMPONENT ${component})
  foreach(header IN LISTS ARGN)
    set(path ${PROJECT_SOURCE_DIR}/include/cellsweep/${header})
    if(IS_DIRECTORY ${path})
      install(DIRECTORY ${path} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cellsweep COMPONENT ${component})
    else()
      install(FILES ${path} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cellsweep COMPONENT ${component})
    endif()
  endforeach()
  set(CELLSWEEP_PC_NAME ${target})
  string(REPLACE "_" "-" CELLSWEEP_PC_FILE ${target})
  set(CELLSWEEP_PC_REQUIRES "${requires}")
  set(CELLSWEEP_PC_LIBS "${libs}")
  configure_file(${PROJECT_SOURCE_DIR}/src/cmake/cellsweep.pc.in ${CELLSWEEP_PC_FILE}.pc @ONLY)
  install(
    FILES ${CMAKE_CURRENT_BINARY_DIR}/${CELLSWEEP_PC_FILE}.pc
    DESTINATION ${cellsweep_pc_dir}
    COMPONENT ${component})
endfunction()

cellsweep_install_library(
  core cellsweep "" " -pthread"
  aabb.h box_view.h broadphase.h c c.h engine engines.h executor.h export.h filter.h find_pairs.h function_ref.h options.h pair.h
  pair_history.h query.h statistics.h status.h stream_view.h vector_isa.h)
if(TARGET cellsweep_world)
  cellsweep_install_library(world cellsweep_world "cellsweep eigen3" "${CELLSWEEP_LIBZIP}" pose.h world)
endif()
if(TARGET cellsweep_cell)
  cellsweep_install_library(cell cellsweep_cell "cellsweep" " -lspu_emu -pthread -ldl" cell.h local_store.h pose.h)
endif()
if(TARGET cellsweep_embree)
  cellsweep_install_library(embree cellsweep_embree "cellsweep" " -lembree3" embree.h)
endif()
if(TARGET cellsweep_ranks)
  cellsweep_install_library(ranks cellsweep_ranks "cellsweep mpi-cxx" " -ltrilinos_zoltan${CELLSWEEP_LIBHDF5}" checkpoint.h ranks.h)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/cellsweep-config.cmake.in cellsweep-config.cmake
                              INSTALL_DESTINATION ${cellsweep_package_dir})
write_basic_package_version_file(cellsweep-config-version.cmake COMPATIBILITY SameMajorVersion)
install(
  FILES ${CMAKE_CURRENT_BINARY_DIR}/cellsweep-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/cellsweep-config-version.cmake
  DESTINATION ${cellsweep_package_dir}
  COMPONENT core)
