"""The answers that have several parts: tuples whose parts have names."""

from fractions import Fraction
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

__all__ = ["Arrangement", "BodyPlan", "BoundaryLoop", "Clash", "ClosestPoints", "Combined", "ConvexPart", "CoplanarFace", "CoplanarFaces",
           "CoveringPart", "Delaunay",
           "Contact", "ContactCorner", "Contour", "ExactContact", "ExactContactCorner", "ExactDistance",
           "ExactPenetration", "Feature", "FirstContact", "HausdorffDistance", "Hit", "Intersection", "IntersectionCurve",
           "MeshReport",
           "MergedVertex", "MinimumSphere", "Penetration", "PolynomialRoot", "RepairChange", "Repaired", "SquareRoot", "Support",
           "SurfaceKind", "Voronoi", "Welded", "WorldCast", "WorldCastSpan", "WorldContact",
           "WorldContactSpan", "WorldCorner", "WorldCornerEvents", "WorldEvents", "WorldHit", "WorldImpact",
           "WorldNear", "WorldNearPair", "WorldPlan"]


class Feature(NamedTuple):
    """A vertex, an edge or a face of a figure, or its interior, by number; docs/figures.md says which is which."""

    kind: str  # "vertex", "edge", "face" or "interior"
    number: int


class SquareRoot(NamedTuple):
    """The number base - sqrt(square), or base + sqrt(square) where it is the greater of two roots."""

    base: Fraction
    square: Fraction
    greater: bool


class PolynomialRoot(NamedTuple):
    """The one root of a polynomial between two bounds."""

    coefficients: List[int]  # in ascending order
    bounds: Tuple[Fraction, Fraction]


class ExactDistance(NamedTuple):
    """The number sqrt(square) - inset, which is zero where that is negative."""

    square: Fraction
    inset: Fraction


class ClosestPoints(NamedTuple):
    """The two points that are nearest to one another, and how far apart they are."""

    on_a: Any  # float64, shape (3,), or (2,) of figures of the plane
    on_b: Any
    distance: float
    feature_a: Feature
    feature_b: Feature


class Clash(NamedTuple):
    """Two parts of an assembly that are in each other's way."""

    a: Any  # their names
    b: Any
    word: str  # "within clearance", "touching", "overlapping", "piercing through", "enclosed" or "duplicate"
    place: Any  # float64, shape (3,)
    distance: Optional[float]  # of what is within clearance
    inner: Any  # the name of the one that lies in the other
    volume: Optional[float]  # in common, of two solids whose insides meet
    depth: Optional[Tuple[float, float]]  # no shorter translation than the first frees them, one of the second does
    direction: Any  # float64, shape (3,): the first part leaves along it
    meeting: Any  # int32, shape (n, 2): triangles of a and of b that meet


class Hit(NamedTuple):
    """Where a ray, a segment or a line first meets a figure."""

    t: Any  # float, in lengths of the direction; where exact: Fraction or SquareRoot
    point: Any  # float64, shape (3,), or (2,) of figures of the plane
    feature: Feature
    normal: Any  # of any length


class FirstContact(NamedTuple):
    """When do two moving figures first meet, and with which features?"""

    time: Any  # float from 0 to 1, never late; where exact: Fraction or PolynomialRoot
    feature_a: Feature
    feature_b: Feature


class Penetration(NamedTuple):
    """The least translation of the first body that parts it from the second."""

    depth: float
    direction: Any  # float64, shape (3,), of length 1
    translation: Any
    feature_a: Feature
    feature_b: Feature
    is_unique: bool


class ExactPenetration(NamedTuple):
    """The same without rounding: depth is radii and the root of core_square, or less it where the cores are apart."""

    direction: Tuple[Fraction, Fraction, Fraction]
    core_translation: Tuple[Fraction, Fraction, Fraction]
    core_square: Fraction
    cores_are_apart: bool
    radii: Fraction
    feature_a: Feature
    feature_b: Feature
    is_unique: bool


class ContactCorner(NamedTuple):
    """A corner of a contact, with a name that stays the same from frame to frame."""

    on_a: Any  # float64, shape (3,)
    on_b: Any
    distance: float  # along the normal; below zero where the bodies overlap there
    id: Tuple[Feature, Feature]


class Contact(NamedTuple):
    """Where two convex bodies touch, or nearly touch, or how deep they are in one another."""

    relation: Any  # Relation
    normal: Any  # float64, shape (3,), from the first body to the second, of length 1
    distance: float
    corners: List[ContactCorner]


class ExactContactCorner(NamedTuple):
    """A corner of a contact of the bodies' cores, without rounding."""

    on_a: Tuple[Fraction, Fraction, Fraction]
    on_b: Tuple[Fraction, Fraction, Fraction]
    along: Fraction  # from the one to the other, as a multiple of the direction
    id: Tuple[Feature, Feature]


class ExactContact(NamedTuple):
    """The same without rounding: the distance is along * |direction| - radius_a - radius_b, and of each corner likewise."""

    relation: Any  # Relation
    direction: Tuple[Fraction, Fraction, Fraction]
    along: Fraction
    radius_a: Fraction
    radius_b: Fraction
    corners: List[ExactContactCorner]


class Support(NamedTuple):
    """The farthest point of a figure along a direction."""

    point: Any  # float64, shape (3,), or (2,) of figures of the plane
    feature: int
    unique: bool


class Intersection(NamedTuple):
    """The points that two figures have in common."""

    kind: str  # "nothing", "point", "segment", "ray", "line", "polygon", "solid", "plane" or "space"
    vertices: Any  # float64, shape (n, 3) or (n, 2); where exact: a list of tuples of Fraction
    directions: List[Tuple[Fraction, ...]]  # of a solid, a line or a plane that goes on forever
    faces: List[List[int]]  # of a bounded solid


class MinimumSphere(NamedTuple):
    """The smallest ball or disk that holds points, and which of them define it."""

    ball: Any  # Circle2 or Sphere3, rounded once
    support: Any  # int32, shape (k,): the points that it is the smallest ball of


class MeshReport(Dict[str, Any]):
    """What is wrong with a mesh: a dict by the names of `plumb check --json`, which prints in the words of `plumb check`."""

    def __init__(self, members: Dict[str, Any], text: str) -> None:
        super().__init__(members)
        self._text = text

    def __str__(self) -> str:
        return self._text

    def __reduce__(self) -> Any:
        return MeshReport, (dict(self), self._text)


class RepairChange(NamedTuple):
    """One change that mended a mesh, or what was left as it was."""

    what: str
    step: str
    place: Any  # float64, shape (3,)
    how_many: int
    distance: float
    is_left: bool


class Repaired(NamedTuple):
    """A mesh that was mended, what was changed, and what is still wrong with it."""

    mesh: Any  # Mesh
    changes: List[RepairChange]
    report: MeshReport


class Delaunay(NamedTuple):
    """Triangles between points of the plane, counterclockwise, none with a point in its circle."""

    simplices: Any  # int32, shape (n, 3)
    neighbors: Any  # int32, shape (n, 3): over the edge from corner k to the next; -1 where there is none


class Voronoi(NamedTuple):
    """The centers of the circles of a Delaunay triangulation; edges join those of neighbors."""

    vertices: Any  # float64, shape (n, 2), rounded once; where exact: a list of pairs of Fraction
    simplices: Any  # int32, shape (n, 3): the three points around each
    neighbors: Any  # int32, shape (n, 3): -1 where an edge has no end


class Arrangement(NamedTuple):
    """Where segments cross and overlap, the edges between, and the faces; face 0 is the one without bounds."""

    vertices: Any  # float64, shape (n, 2), rounded once; where exact: a list of pairs of Fraction
    ends: Any  # int32, shape (s, 2): the vertices at which each segment ends
    edges: Any  # int32, shape (m, 2): from the lower vertex to the higher
    sides: Any  # int32, shape (m, 2): the faces on the left and on the right
    faces: int
    windings: Any  # int32, shape (faces,); None where some vertex is left more often than entered, or less
    triangles: Any  # int32, shape (k, 3): those of the convex hull
    face_of: Any  # int32, shape (k,): the face of each triangle


class BoundaryLoop(NamedTuple):
    """Vertices along which a surface ends, in the order in which the triangles beside them run."""

    vertices: Any  # int32, shape (n,)
    closed: bool  # else a chain between edges of more than two triangles


class SurfaceKind(NamedTuple):
    """What kind of surface a component is: a sphere has euler 2 and genus 0, a torus 0 and 1."""

    vertices: int
    edges: int
    faces: int
    loops: int
    orientable: bool
    euler: int
    genus: int  # handles; crosscaps where it is not orientable


class MergedVertex(NamedTuple):
    """A vertex that became another, and how far it moved."""

    vertex: int
    into: int
    distance: float


class Welded(NamedTuple):
    """A mesh whose vertices were welded, and what became of them and of the triangles."""

    mesh: Any  # Mesh
    into: Any  # int32, shape (n,): of each vertex, its own number where it stays
    merged: List[MergedVertex]
    collapsed: Any  # int32: triangles two corners of which became one
    turned: Any  # int32: triangles that are turned over
    refused: Any  # int32: first vertices of groups that fell apart, since triangles would turn over


class CoplanarFace(NamedTuple):
    """Neighboring triangles in one plane, as a polygon with holes."""

    rings: List[Any]  # int32 arrays of vertices: the outer ring, then the holes
    triangles: Any  # int32, ascending
    plane: int  # the triangle in whose plane it is


class CoplanarFaces(NamedTuple):
    """All of a mesh's faces, and the mesh of as few triangles as they take."""

    faces: List[CoplanarFace]
    apart: Any  # int32: first triangles of those that become no polygon
    mesh: Any  # Mesh


class ConvexPart(NamedTuple):
    """A convex polyhedron that is a part of a solid."""

    vertices: Any  # float64, shape (n, 3), rounded once
    faces: List[Any]  # int32 arrays, counterclockwise seen from outside
    is_exact: bool  # its corners are doubles
    volume: Fraction


class CoveringPart(NamedTuple):
    """A convex hull that covers a share of a solid."""

    vertices: Any  # float64, shape (n, 3): all of them are its corners
    concavity: float  # no point of the hull is farther from its share than this


class Combined(NamedTuple):
    """A solid made of others, exactly, and rounded once."""

    mesh: Any  # Mesh
    sound: bool  # closed, wound outward and free of crossings: decided of the mesh as it is told
    moved: float  # no point is farther than this from the exact solid
    sources: Any  # int32, shape (n, 2): of each face, which mesh and which face of it it is a piece of


class IntersectionCurve(NamedTuple):
    """A polyline where two surfaces meet, or a point where they touch."""

    points: Any  # float64, shape (n, 3), rounded once; where exact: a list of tuples of three Fraction
    closed: bool  # then the first point is not told again
    faces: Any  # int32, shape (k, 2): a face of a and one of b for each edge; of one point, for that


class Contour(NamedTuple):
    """A contour of a section of a mesh by a plane, or a chain where the mesh is open."""

    points: Any  # float64, shape (n, 3): the corners, rounded once
    closed: bool
    turn: int  # 1: counterclockwise seen from the normal's side; -1: a hole; 0: no area
    parent: Optional[int]  # the contour around it
    depth: int  # how many lie around it


class HausdorffDistance(NamedTuple):
    """Between which numbers is the distance of two surfaces from one another, and where is it attained?"""

    least: float
    most: float
    is_within: bool  # the tolerance that was asked for
    of_other: bool  # the point is one of the other mesh
    point: Any  # float64, shape (3,)


class WorldEvents(NamedTuple):
    """Pairs of bodies, by handles, that have begun to meet, are kept, and have ended."""

    begun: Any  # uint64, shape (n, 2)
    kept: Any
    ended: Any


class WorldContact(NamedTuple):
    """Where a part of a body touches a part of another one."""

    a: int  # handles
    b: int
    part_a: Tuple[int, int]  # the part of a compound and the triangle of a mesh, 0 where there is one alone
    part_b: Tuple[int, int]
    contact: Contact


class WorldCorner(NamedTuple):
    """A corner of a contact by its name, which stays the same from frame to frame."""

    a: int
    b: int
    part_a: Tuple[int, int]
    part_b: Tuple[int, int]
    id: Tuple[Feature, Feature]


class WorldCornerEvents(NamedTuple):
    """Corners of contacts that have begun and have ended."""

    begun: List[WorldCorner]
    ended: List[WorldCorner]


class BodyPlan(NamedTuple):
    """Which proxy pays for a body of a world, and what it saves."""

    body: int
    proxy: str  # "none", "sphere", "box" or "hull"
    pairs: int  # it is in
    told_apart: int  # of these, by the proxies
    saved: int  # questions


class WorldPlan(NamedTuple):
    """Which proxies a world should have, and how many questions a commit asks without and with them."""

    bodies: List[BodyPlan]  # those that are no single figure and are in a pair of several questions
    questions_without: int
    questions_with: int
    index: Optional[str]  # the broad phase that is expected to be the fastest; None of an empty world


class WorldCastSpan(NamedTuple):
    """A body that a turning figure does not meet before a span of time, and may meet in it."""

    body: int
    begin: float
    end: float
    is_certain: bool  # that it does


class WorldContactSpan(NamedTuple):
    """Two bodies of a world that do not meet before a span of time, and may meet in it."""

    a: int
    b: int
    begin: float
    end: float
    is_certain: bool  # that they do


class WorldHit(NamedTuple):
    """Which body of a world a ray hits first, and where."""

    body: int
    part: Tuple[int, int]
    t: float  # in lengths of the direction
    point: Any  # float64, shape (3,)
    normal: Any  # of any length


class WorldNear(NamedTuple):
    """A body of a world, and how far it is from what was asked about."""

    body: int
    part: Tuple[int, int]
    distance: float


class WorldNearPair(NamedTuple):
    """Two bodies of a world, and how far they are apart."""

    a: int
    b: int
    part_a: Tuple[int, int]
    part_b: Tuple[int, int]
    distance: float


class WorldCast(NamedTuple):
    """The body of a world that a moving figure comes to first."""

    body: int
    part: Tuple[int, int]
    contact: FirstContact


class WorldImpact(NamedTuple):
    """Two bodies of a world that meet in motion; those of one rank do at exactly one time."""

    a: int
    b: int
    part_a: Tuple[int, int]
    part_b: Tuple[int, int]
    contact: FirstContact
    rank: int
