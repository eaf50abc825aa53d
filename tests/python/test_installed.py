"""Is the package found where pip and `cmake --install` put it, by a Python that knows nothing of this tree?"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import plumb

TREE = Path(__file__).resolve().parents[2]
# The build that the package is imported from: nothing is compiled here.
BUILD = Path(plumb.__file__).resolve().parents[3]


@pytest.fixture
def machine(tmp_path):
    """Debian's Python with its packages, in a folder of its own."""
    if not (BUILD / "CMakeCache.txt").exists():
        pytest.skip("plumb is not imported from a build")
    folder = tmp_path / "machine"
    ran([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", folder])
    return folder


def ran(command, **environment):
    """What it said; fails with what it said."""
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | environment
    run = subprocess.run([str(word) for word in command], env=clean, cwd="/", capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


def expect_there(machine):
    """The package in this folder, whole, without a library of ours beside it."""
    ask = "import plumb, plumb.degenerate as d; print(plumb.__file__, plumb.orient2d([0, 0], [1, 0], [0, 1]), d.__name__)"
    file, *answers = ran([machine / "bin/python", "-c", ask]).split()
    package = Path(file).parent
    assert answers == ["1", "plumb.degenerate"] and package.is_relative_to(machine)
    assert {"py.typed", "_plumb.pyi", "degenerate"} <= {path.name for path in package.iterdir()}
    modules = list(package.glob("_plumb*.so"))
    assert len(modules) == 1 and "libplumb" not in ran(["readelf", "-d", modules[0]])


def test_by_pip_without_a_network(machine):
    pytest.importorskip("pip")
    ran([machine / "bin/python", "-m", "pip", "install", "--no-index", "--no-build-isolation", "--no-cache-dir",
         TREE / "src/python"], PLUMB_PYTHON_BUILD=str(BUILD))
    expect_there(machine)


def test_by_cmake(machine):
    ran(["cmake", "--install", BUILD, "--component", "python", "--prefix", machine])
    expect_there(machine)


def test_by_cmake_where_there_is_no_python(machine):
    prefix = machine.parent / "prefix"
    ran(["cmake", "--install", BUILD, "--component", "python", "--prefix", prefix])
    assert [path.name for path in prefix.glob("lib/python3.*/site-packages/plumb/__init__.py")] == ["__init__.py"]
