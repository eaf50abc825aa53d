"""What pickles call to make a value again: pickle finds functions of Python by name, those of C++ it does not."""

import tempfile
from pathlib import Path
from typing import Any

from . import _plumb


def figure(line: str) -> Any:
    """The figure of a line."""
    return _plumb.parse_figure(line)


def tree(content: bytes) -> Any:
    """The tree of a file's bytes."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "tree.bvh"
        path.write_bytes(content)
        return _plumb.read_bvh(path)
