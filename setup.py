"""Builds the package with CMake: the compiled module, libburnish and the command line land in the package's folder.

BURNISH_BUILD names a CMake build to take them from instead of making one; CMAKE_ARGS is handed to CMake.
"""

import os
import pathlib
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    """Configures, builds and installs CMake's `python` component where setuptools wants the extension."""

    def build_extension(self, ext):
        """Build the one extension there is."""
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        ready = os.environ.get("BURNISH_BUILD")
        build = pathlib.Path(ready or self.build_temp).resolve()
        if not ready:
            self.make(build)
        subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", target.parent], check=True)

    def make(self, build):
        """Configure and build, without the tests."""
        configure = ["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DBURNISH_TESTS=OFF",
                     f"-DPython_EXECUTABLE={sys.executable}", *os.environ.get("CMAKE_ARGS", "").split()]
        subprocess.run(configure, check=True)
        subprocess.run(["cmake", "--build", build, "--parallel", str(os.cpu_count() or 1)], check=True)


setup(ext_modules=[Extension("burnish._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
