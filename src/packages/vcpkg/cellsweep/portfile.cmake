# An overlay port that builds the sources it lies in: vcpkg install cellsweep --overlay-ports=src/packages/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)
vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS FEATURES world CELLSWEEP_WITH_WORLD)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DCELLSWEEP_BUILD_APP=OFF
    -DCELLSWEEP_BUILD_TESTS=OFF
    -DCELLSWEEP_BUILD_BENCHMARKS=OFF
    -DCELLSWEEP_CELL_ENGINES=OFF
    -DCELLSWEEP_WITH_EMBREE=OFF
    -DCELLSWEEP_WITH_PYTHON=OFF
    -DCELLSWEEP_WITH_ZIP=OFF
    ${FEATURE_OPTIONS})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME cellsweep CONFIG_PATH lib/cmake/cellsweep)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
