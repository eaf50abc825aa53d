"""Strategies of hypothesis whose examples are the library's hard inputs.

>>> from hypothesis import given, settings
>>> import plumb
>>> from plumb.degenerate.strategies import pairs
>>> @settings(database=None, deadline=None)
... @given(pairs(plumb.Triangle3, plumb.Segment3))
... def test_distance_is_symmetric(pair):
...     a, b = pair
...     assert plumb.distance(a, b) == plumb.distance(b, a)
>>> test_distance_is_symmetric()
"""

from typing import Any

from hypothesis import strategies as st

from .. import _plumb

__all__ = ["figures", "pairs", "points"]

# Of one length: hypothesis prefers short ones, and what is beyond the end is chosen to be zero.
_choices = st.binary(min_size=256, max_size=256)


def _require_kinds(*kinds: Any) -> None:
    for kind in kinds:
        if getattr(kind, "__name__", None) not in _plumb._generated_classes:
            raise ValueError(f"no hard inputs are made of {kind!r}; there are {', '.join(_plumb._generated_classes)}")


def figures(kind: Any) -> Any:
    """Figures of a class such as `plumb.Triangle3`: plain ones, needles, caps, slivers, flat, straight, single points, empty.

    Coordinates are of every size, many of them tiny, huge or a last bit from another.  An example shrinks to small integers.
    """
    _require_kinds(kind)
    return _choices.map(lambda bits: _plumb._generate(kind.__name__, bits)).filter(lambda f: f is not None)


def pairs(first: Any, second: Any) -> Any:
    """Pairs of figures that touch, share an edge, lie in one plane, contain one another, or so but for a last bit.

    Both are of the plane or both of space.
    """
    _require_kinds(first, second)
    if first.__name__[-1] != second.__name__[-1]:
        raise ValueError("a figure of the plane and one of space are no pair")
    made = _choices.map(lambda bits: _plumb._generate_pair(first.__name__, second.__name__, bits))
    return made.filter(lambda pair: pair is not None)


def points(dimension: int = 3) -> Any:
    """Points as arrays of float64, shape (2,) or (3,), of every size."""
    if dimension not in (2, 3):
        raise ValueError(f"dimension is {dimension}; give 2 or 3")
    return figures(_plumb.Point2 if dimension == 2 else _plumb.Point3).map(lambda p: p.coordinates)
