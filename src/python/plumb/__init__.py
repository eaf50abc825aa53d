"""Exact geometry of float64 arrays: signs, figures, meshes, trees and hulls that real arithmetic would give.

Every decision taken here (a sign, a yes or no, which triangle, which order) is the one that real arithmetic gives for the
doubles it was handed.  Points are arrays of shape (n, 2) or (n, 3) of float64; float32 and integers widen without rounding;
indices are int32 and signs int8.  What is wrong with an argument is a ValueError or TypeError that names it.

>>> import plumb
>>> plumb.orient2d([0, 0], [0.1, 0.3], [0.3, 0.9])          # not on one line: 0.1, 0.3, 0.9 are doubles
1
>>> plumb.orient2d([0, 0], [0.5, 1.5], [[1, 3], [2, 5]])    # broadcasts as a ufunc does
array([ 0, -1], dtype=int8)
>>> plumb.distance(plumb.Sphere3([0, 0, 0], 1), [3, 4, 0])
4.0
"""

from . import _picture, _plumb, answers
from ._plumb import *
from .answers import *

# A class of pybind11 takes methods that are written in Python as well; the stub declares them.
setattr(_plumb.Mesh, "_repr_html_", _picture.repr_html)
setattr(_plumb.Mesh, "show", _picture.show)

__all__ = _plumb.__all__ + answers.__all__
