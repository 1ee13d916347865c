"""Builds the compiled part of the Python module with CMake.

A build tree that exists already is used if the environment names it: EXSECT_BUILD_DIR=build/release.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        target = Path(self.get_ext_fullpath(ext.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        tree = Path(os.environ.get("EXSECT_BUILD_DIR") or Path(self.build_temp) / "cmake").resolve()
        if not (tree / "CMakeCache.txt").exists():
            options = ["-DCMAKE_BUILD_TYPE=Release", "-DEXSECT_BUILD_TESTS=OFF", "-DEXSECT_INSTALL=OFF"]
            options += ["-DEXSECT_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
            if "CMAKE_GENERATOR" not in os.environ and shutil.which("ninja"):
                options += ["-G", "Ninja"]
            try:
                import pybind11

                options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
            except ImportError:
                pass  # CMake finds Debian's pybind11-dev
            subprocess.run(["cmake", "-S", str(ROOT), "-B", str(tree), *options], check=True)
        subprocess.run(["cmake", "--build", str(tree), "--target", "exsect_python", "--parallel", str(os.cpu_count())], check=True)
        built = tree / "python" / "exsect" / target.name
        if not built.exists():
            raise RuntimeError(f"{tree} was not configured for the interpreter {sys.executable}: no {built}")
        self.copy_file(str(built), str(target))


version = re.search(r"project\(exsect VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("exsect._core", [])], cmdclass={"build_ext": CMakeBuild})
