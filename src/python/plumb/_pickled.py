"""What pickles call to make a value again: pickle finds functions of Python by name, those of C++ it does not."""

from typing import Any

from . import _plumb


def figure(line: str) -> Any:
    """The figure of a line."""
    return _plumb.parse_figure(line)
