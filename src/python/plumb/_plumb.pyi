"""The stubs of the module; tests/python/test_documents.py holds them against it.

Those of its rooms stand beside it, in files that no Python imports."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import answers
from ._figure_stubs import *
from ._mesh_stubs import *
from ._sign_stubs import *
from ._world_stubs import *

__all__ = [
    "Aabb2",
    "Aabb3",
    "Bvh",
    "Capsule2",
    "Capsule3",
    "Circle2",
    "CollisionWorld",
    "Cone3",
    "ConvexHull",
    "ConvexPolyhedron3",
    "Cylinder3",
    "ExactMesh",
    "Figure",
    "Halfspace2",
    "Halfspace3",
    "HalfspaceIntersection2",
    "HalfspaceIntersection3",
    "Heightfield",
    "HoledPolygon2",
    "HoledPolygon3",
    "KDTree",
    "KDop2",
    "KDop3",
    "Line2",
    "Line3",
    "Location",
    "Lozenge3",
    "Mesh",
    "Obb2",
    "Obb3",
    "Plane3",
    "Point2",
    "Point3",
    "Polygon2",
    "Polygon3",
    "Quadrilateral2",
    "Quadrilateral3",
    "Ray2",
    "Ray3",
    "Rectangle3",
    "Relation",
    "Segment2",
    "Segment3",
    "Sphere3",
    "SphericalCap3",
    "Tetrahedron3",
    "ThreadLimit",
    "ThreePointPlane3",
    "Triangle2",
    "Triangle3",
    "angle_sign",
    "are_ordered_along_line",
    "arrange_segments",
    "ask",
    "boundary_loops",
    "check",
    "clash",
    "closest_points",
    "collinear",
    "compare_along_direction",
    "compare_along_line",
    "compare_distance",
    "compare_distance_to_line",
    "compare_distance_to_lines",
    "compare_distance_to_plane",
    "compare_distance_to_planes",
    "compare_distance_to_segment",
    "compare_distance_to_segments",
    "compare_lexicographically",
    "compare_power",
    "compare_signed_distance_to_line",
    "compare_signed_distance_to_plane",
    "components",
    "contact",
    "contains",
    "convex_parts",
    "convex_pieces",
    "coplanar_orientation",
    "covering_parts",
    "cross_sign",
    "delaunay",
    "determinant_sign",
    "distance",
    "dot_of_crosses",
    "dot_sign",
    "first_contact",
    "first_hit",
    "evaluate",
    "fit_aabb",
    "in_power_circle",
    "in_power_sphere",
    "in_smallest_circle",
    "in_smallest_sphere",
    "incircle",
    "insphere",
    "intersect",
    "intersection",
    "intersection_curves",
    "intersects",
    "line_edge",
    "locate",
    "merge_coplanar",
    "minimum_obb",
    "minimum_sphere",
    "order_along_cross",
    "orient2d",
    "orient3d",
    "orient_seen_from",
    "overlapping_pairs",
    "parallel",
    "parse_figure",
    "penetration",
    "perpendicular",
    "power_sign",
    "read_bvh",
    "read_mesh",
    "relate",
    "repair",
    "resolve",
    "sections",
    "side_of_line",
    "side_of_plane",
    "sign_of_radicals",
    "split",
    "squared_distance",
    "subtract",
    "support_point",
    "support_value",
    "surface_kinds",
    "symmetric_difference",
    "triangulate",
    "unite",
    "voronoi",
    "weld",
]

class ThreadLimit:
    def __init__(self, most: int) -> None: ...
    def __enter__(self) -> int: ...
    def __exit__(self, *exception: object) -> None: ...

class KDTree:
    def __init__(self, points: ArrayLike) -> None: ...
    def __len__(self) -> int: ...
    @property
    def data(self) -> NDArray[np.float64]: ...
    @property
    def n(self) -> int: ...
    @property
    def m(self) -> int: ...
    def query(self, x: ArrayLike, k: int = 1, *, ties: str = "lowest") -> tuple[Any, Any]: ...
    def query_ball_point(self, x: ArrayLike, r: ArrayLike, *, return_length: bool = False) -> Any: ...

class ConvexHull:
    def __init__(self, points: ArrayLike) -> None: ...
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def vertices(self) -> NDArray[np.int32]: ...
    @property
    def simplices(self) -> NDArray[np.int32]: ...
    @property
    def neighbors(self) -> NDArray[np.int32]: ...
    @property
    def equations(self) -> NDArray[np.float64]: ...
    @property
    def volume(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def dimension(self) -> int: ...

def minimum_sphere(points: ArrayLike) -> answers.MinimumSphere: ...
def minimum_obb(points: ArrayLike) -> Any: ...
def overlapping_pairs(
    boxes: ArrayLike, others: ArrayLike | None = None, *, touching: bool = True
) -> NDArray[np.int32]: ...

_generated_classes: tuple[str, ...]
_fuzz_kinds: dict[str, str]

def _generate(name: str, choices: bytes) -> Any: ...
def _generate_pair(first: str, second: str, choices: bytes) -> Any: ...
def _fuzz(
    function: Callable[..., Any],
    kind: str,
    seed: int,
    cases: int,
    generators: Sequence[str],
    ulps: int | None,
    largest: float,
    progress: Callable[[int], Any] | None,
) -> tuple[list[Any], list[Any], str]: ...
