"""Do the examples of the page and of the docstrings give what they show, and do the stubs tell what there is?"""

import doctest
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

import plumb

TREE = Path(__file__).resolve().parents[2]
PAGE = TREE / "docs" / "python.md"


def test_page():
    # The fence that ends a block is no output.
    text = re.sub(r"^```.*$", "", PAGE.read_text(), flags=re.M)
    examples = doctest.DocTestParser().get_doctest(text, {}, PAGE.name, str(PAGE), 0)
    assert len(examples.examples) > 10
    told = []
    results = doctest.DocTestRunner().run(examples, out=told.append)
    assert results.failed == 0, "".join(told)


def test_docstrings():
    results = doctest.testmod(plumb)
    assert results.attempted > 2 and results.failed == 0


def test_page_names_every_function():
    named = set(re.findall(r"`(\w+)`", PAGE.read_text()))
    assert {name for name in plumb.__all__ if name.islower()} <= named


@pytest.mark.parametrize("name", plumb.__all__)
def test_has_a_docstring(name):
    docstring = getattr(plumb, name).__doc__
    assert docstring and len(docstring) > 40


def mypy(module, *arguments):
    """On the folder of the package, for mypy reads no stubs of its own path."""
    here = Path(plumb.__file__).resolve().parents[1]
    environment = {**os.environ, "MYPYPATH": str(here), "PYTHONPATH": str(here)}
    return subprocess.run([sys.executable, "-m", module, *arguments], env=environment, cwd=tempfile.gettempdir(),
                          capture_output=True, text=True)


def test_stubs_tell_what_there_is(tmp_path):
    pytest.importorskip("mypy")
    # A class of pybind11 has a metaclass of its own; its members are compared like all others.
    classes = [name for name in plumb._plumb.__all__ if isinstance(getattr(plumb, name), type)]
    allowed = tmp_path / "allowed"
    allowed.write_text("".join(f"plumb._plumb.{name}\nplumb._plumb.{name}.__members__\n" for name in classes))
    run = mypy("mypy.stubtest", "--allowlist", str(allowed), "--ignore-unused-allowlist", "plumb._plumb")
    assert run.returncode == 0, run.stdout + run.stderr


def test_stubs_are_checked(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "user.py"
    program.write_text("import numpy as np\nimport plumb\n"
                       "signs = plumb.orient2d([0, 0], np.zeros((5, 2)), [1, 1])\n"
                       "with plumb.ThreadLimit(1) as threads:\n    n: int = threads\n"
                       "ball = plumb.Sphere3([0, 0, 0], radius=1.0)\n"
                       "far: float = plumb.closest_points(ball, [1, 2, 3]).distance\n")
    run = mypy("mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(program))
    assert run.returncode == 0, run.stdout + run.stderr
    program.write_text("import plumb\nplumb.orient2d([0, 0], [1, 1])\n")
    run = mypy("mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(program))
    assert run.returncode == 1 and "Missing positional argument" in run.stdout
