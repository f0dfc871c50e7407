"""Lets CMake build the extension; all else is in pyproject.toml. The environment variable CMAKE_ARGS adds options."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"project\(unsliver VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def pybind11_options():
    """Where pybind11 came as a Python package; Debian's pybind11-dev is found without."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_ROOT={pybind11.get_cmake_dir()}"]


def generator():
    """Ninja where it is, unless the environment names another one."""
    return ["-GNinja"] if shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ else []


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        folder = Path(self.get_ext_fullpath(extension.name)).resolve().parent
        build = Path(self.build_temp).resolve()
        options = {"CMAKE_BUILD_TYPE": "Release", "UNSLIVER_BUILD_PYTHON": "ON", "UNSLIVER_BUILD_CLI": "OFF",
                   "UNSLIVER_BUILD_TESTS": "OFF", "UNSLIVER_INSTALL": "OFF", "UNSLIVER_WERROR": "OFF",
                   "Python_EXECUTABLE": sys.executable, "UNSLIVER_PYTHON_MODULE_DIR": folder}
        build.mkdir(parents=True, exist_ok=True)
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator(), *definitions, *pybind11_options(),
                        *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", build, "--target", "unsliver_python", "--parallel", jobs], check=True)


setup(version=VERSION, ext_modules=[Extension("unsliver._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
