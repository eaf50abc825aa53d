"""Builds the module by the project's own CMake, from the tree that this folder lies in.

    pip install src/python --no-build-isolation

PLUMB_PYTHON_BUILD names a folder of a build that is there already (build/python), so that nothing is compiled twice.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

TREE = Path(__file__).resolve().parents[2]
# All that is made on the way stands where the tree's builds are, not among its sources.
MADE = TREE / "build" / "wheel"
MADE.mkdir(parents=True, exist_ok=True)


class BuildByCMake(build_ext):
    """The extension is a target of the tree's CMake."""

    def build_extension(self, ext: Extension) -> None:
        to = Path(self.get_ext_fullpath(ext.name)).resolve()
        there = os.environ.get("PLUMB_PYTHON_BUILD")
        folder = Path(there).resolve() if there else MADE / "cmake"
        if not there:
            subprocess.run(["cmake", "--preset", "python", "-B", str(folder), f"-DPython3_EXECUTABLE={sys.executable}"],
                           cwd=TREE, check=True)
        subprocess.run(["cmake", "--build", str(folder), "--target", "plumb_python"], check=True)
        made = folder / "src" / "python" / "plumb" / to.name
        if not made.exists():
            sys.exit(f"plumb: {made} is not there: {folder} is of another Python than {sys.executable}")
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(made, to)


setup(
    ext_modules=[Extension("plumb._plumb", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={"build": {"build_base": str(MADE)}, "egg_info": {"egg_base": str(MADE)}},
)
