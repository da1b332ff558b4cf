"""Builds the extension of the Python package with CMake; all else stands in pyproject.toml."""

import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = pathlib.Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    """Configures the library and its module, and puts the module where setuptools expects it."""

    def build_extension(self, extension):
        build = pathlib.Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        parts = ["APP", "TESTS", "BENCHMARKS"]
        subprocess.check_call(
            ["cmake", "-S", PROJECT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}"]
            + [f"-DCELLSWEEP_BUILD_{part}=OFF" for part in parts]
            + ["-DCELLSWEEP_CELL_ENGINES=OFF", "-DCELLSWEEP_WITH_EMBREE=OFF", "-DCELLSWEEP_REQUIRE_PYTHON=ON"]
            + shlex.split(os.environ.get("CMAKE_ARGS", ""))
        )
        subprocess.check_call(
            ["cmake", "--build", build, "--target", "cellsweep_python", "--parallel", str(os.cpu_count() or 1)]
        )
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        made = build / "src/bindings/python/cellsweep" / target.name
        self.copy_file(str(made), str(target))


def version():
    return re.search(r"project\(\s*cellsweep\s+VERSION ([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text())[1]


setup(version=version(), ext_modules=[Extension("cellsweep._cellsweep", [])], cmdclass={"build_ext": CMakeBuild})
