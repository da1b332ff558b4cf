"""The library for Conan 2: conan create src/packages. Its other parts need what Conan may not have, and are left out."""

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Cellsweep(ConanFile):
    name = "cellsweep"
    version = "1.0.0"
    license = "Apache-2.0"
    description = "An exact, parallel broadphase: which boxes of a moving world overlap"
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}

    def layout(self):
        self.folders.root = "../.."
        cmake_layout(self)

    def export_sources(self):
        project = f"{self.recipe_folder}/../.."
        for part in ("CMakeLists.txt", "LICENSE", "include/*", "src/*"):
            copy(self, part, project, self.export_sources_folder)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in ("BUILD_APP", "BUILD_TESTS", "BUILD_BENCHMARKS", "CELL_ENGINES"):
            toolchain.variables[f"CELLSWEEP_{part}"] = False
        for part in ("WORLD", "EMBREE", "ZIP", "PYTHON"):
            toolchain.variables[f"CELLSWEEP_WITH_{part}"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")

    def package_info(self):
        self.cpp_info.libs = ["cellsweep"]
        self.cpp_info.set_property("cmake_file_name", "cellsweep")
        self.cpp_info.set_property("cmake_target_name", "cellsweep::cellsweep")
        self.cpp_info.set_property("pkg_config_name", "cellsweep")
        if self.settings.os == "Linux":
            self.cpp_info.system_libs = ["pthread", "m"]
