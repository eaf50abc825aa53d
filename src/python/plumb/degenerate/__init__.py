"""Hard inputs for code of your own: figures that are needles, slivers and flat, and pairs that touch or nearly do.

`fuzz` holds a function against the exact answers on them.  `plumb.degenerate.strategies` has them as strategies of
hypothesis, which is needed for that module alone.
"""

import sys
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

from .. import _plumb

__all__ = ["Finding", "Findings", "Tally", "fuzz", "kinds"]


class Tally(NamedTuple):
    """How many cases of a generator were asked, and what came of them."""

    generator: str
    asked: int
    wrong: int
    unsure: int  # answered None or NaN, which is no finding
    failed: int  # raised


class Finding(NamedTuple):
    """A case that was answered wrong, made as small as it could be."""

    generator: str
    number: int  # of the case that it was made of
    sort: str  # "0 for +"
    arguments: Tuple[Any, ...]  # arrays, as the function was given them
    given: str
    exact: str
    line: str  # `plumb sign` and `plumb fuzz --case` take it


class Findings(NamedTuple):
    """What a function was asked and what it answered wrong; prints as `plumb fuzz` does."""

    kind: str
    seed: int
    tallies: List[Tally]
    findings: List[Finding]
    text: str

    @property
    def clean(self) -> bool:
        """Nothing was wrong and nothing failed."""
        return all(t.wrong == 0 and t.failed == 0 for t in self.tallies)

    def __str__(self) -> str:
        return self.text


def kinds() -> Dict[str, str]:
    """What can be asked: names, each with the arguments of its function and with what it answers."""
    return dict(_plumb._fuzz_kinds)


def fuzz(function: Callable[..., Any], kind: str, *, seed: int = 2026, cases: int = 1000,
         generators: Optional[Sequence[str]] = None, ulps: Optional[int] = None, largest: float = sys.float_info.max,
         progress: Optional[Callable[[int], Any]] = None) -> Findings:
    """On which inputs is a geometric function wrong, and what is the simplest of them?

    Parameters
    ----------
    function : takes an array for each argument: a point, shape (2,) or (3,), or rows of points and directions; of meshes
        vertices and then triangles, int32.  It answers a number whose sign counts, a truth, a number, for a ray None or
        the parameter of the hit, for a hull rows of three indices; None or NaN where it does not know
    kind : str, one of `kinds()`, such as 'orient2d' or 'triangle-triangle'
    seed : int
    cases : int, of each generator
    generators : sequence of str; all of the kind's where it is None
    ulps : int, how many doubles a number may be from the nearest one; the kind's tolerance where it is None
    largest : float, the largest magnitude that is asked
    progress : called with the number of cases asked; answers False to stop

    Returns
    -------
    Findings

    Raises
    ------
    ValueError
        If there is no such kind or generator.
    TypeError
        If the function answers what is no answer.  What it raises is a finding.

    >>> from plumb.degenerate import fuzz
    >>> def turn(a, b, c):
    ...     return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    >>> found = fuzz(turn, "orient2d", cases=200, generators=["near_half"])
    >>> found.clean, found.findings[0].sort
    (False, '0 for -')
    >>> import plumb
    >>> fuzz(plumb.orient2d, "orient2d", cases=200).clean
    True
    """
    tallies, findings, text = _plumb._fuzz(function, kind, seed, cases, list(generators or []), ulps, largest, progress)
    return Findings(kind, seed, [Tally(*t) for t in tallies], [Finding(*f) for f in findings], text)
