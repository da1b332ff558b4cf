# Finds the Open Dynamics Engine, which brings no CMake package: target ode::ode.
find_path(ODE_INCLUDE_DIR ode/ode.h)
find_library(ODE_LIBRARY ode)
mark_as_advanced(ODE_INCLUDE_DIR ODE_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ode REQUIRED_VARS ODE_LIBRARY ODE_INCLUDE_DIR)
if(ode_FOUND AND NOT TARGET ode::ode)
  add_library(ode::ode UNKNOWN IMPORTED)
  set_target_properties(ode::ode PROPERTIES IMPORTED_LOCATION ${ODE_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES
                                                                             ${ODE_INCLUDE_DIR})
endif()
