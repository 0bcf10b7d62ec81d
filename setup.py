"""The Python module as pip makes it: CMake compiles it and lays it out, data included.

AMBLE_BUILD, in the environment, names a build tree of CMake's that is there already; else there is one of its own, in
build/pip.
"""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
SETTINGS = ["-DCMAKE_BUILD_TYPE=Release", "-DAMBLE_PCH=ON", "-DAMBLE_UNITY=ON", "-DAMBLE_BUILD_TESTS=OFF",
            "-DAMBLE_BUILD_BENCHMARKS=OFF", f"-DPython3_EXECUTABLE={sys.executable}"]


def version():
    return re.search(r"project\(amble VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        package = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        tree = os.environ.get("AMBLE_BUILD")
        if tree is None:
            tree = str(ROOT / "build" / "pip")
            subprocess.run(["cmake", "-S", ROOT, "-B", tree, "-G", "Ninja", *SETTINGS], check=True)
        subprocess.run(["cmake", "--build", tree, "--target", "amble_python"], check=True)
        subprocess.run(["cmake", "--install", tree, "--component", "python", "--prefix", package.parent], check=True)


(ROOT / "build").mkdir(exist_ok=True)
setup(version=version(), packages=["amble"], package_dir={"": "python"},
      package_data={"amble": ["py.typed", "*.pyi"]}, ext_modules=[Extension("amble._amble", [])],
      cmdclass={"build_ext": CMakeBuild}, options={"egg_info": {"egg_base": "build"}})
