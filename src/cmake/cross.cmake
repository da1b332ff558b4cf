# What the toolchains for other processors share: libraries, headers and packages of `target_folder` only, and tools of this
# machine.
set(CMAKE_FIND_ROOT_PATH ${target_folder})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# Packages without compiled code serve every processor; of the build machine's others none may be found.
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "Eigen's CMake package")
set(CLI11_DIR /usr/share/cmake/CLI11 CACHE PATH "CLI11's CMake package")
set(nlohmann_json_DIR /usr/share/cmake/nlohmann_json CACHE PATH "nlohmann-json's CMake package")
